// Handles of objects that the HDF5 library has opened.
#pragma once

#include <hdf5.h>
#include <filesystem>
#include <string>
#include <utility>

namespace discmc::command {

/// Owns an identifier and closes it. A failed opening has no identifier.
class Hdf5Handle {
 public:
  using Close = herr_t (*)(hid_t);

  Hdf5Handle(hid_t id, Close close) : id_(id), close_(close) {}
  Hdf5Handle(Hdf5Handle&& other) noexcept
      : id_(std::exchange(other.id_, H5I_INVALID_HID)), close_(other.close_) {}
  Hdf5Handle& operator=(Hdf5Handle&& other) noexcept {
    std::swap(id_, other.id_);
    std::swap(close_, other.close_);
    return *this;
  }
  ~Hdf5Handle() {
    if (id_ >= 0) close_(id_);
  }

  hid_t id() const { return id_; }
  explicit operator bool() const { return id_ >= 0; }

 private:
  hid_t id_;
  Close close_;
};

/// Registers the filters that unpack LZF and, if discmc was built with Blosc, Blosc.
void register_hdf5_filters();

/// Returns the names of the filters that packed a dataset. Throws VolumeError if a filter is
/// missing. name: of the file, array: of the dataset, for the remedy.
std::string hdf5_filters(const std::filesystem::path& name, const std::string& array,
                         const Hdf5Handle& creation);

}  // namespace discmc::command
