// The description of a volume in a file, the interface of its readers, and filters.
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "label_table.hpp"
#include "meshing.hpp"
#include "samples/slice_reader.hpp"
#include "samples/volume_placement.hpp"
#include "volume_error.hpp"

namespace discmc::command {

/// The description of a volume in its file. An oblique left-handed volume has a negative spacing
/// along z. No shape is therefore mirrored; the placement only turns and moves it.
struct VolumeInfo : SampleGrid {
  /// The extents before cropping and shrinking. Units: voxels.
  std::optional<std::array<std::uint32_t, 3>> whole_dims;
  /// The number of volumes in the file: 3D volumes of a 4D file.
  std::uint64_t frames = 1;
  /// The number of samples per voxel in the file, such as colours or stains; this volume has one.
  std::uint64_t channels = 1;
  /// The place of the volume; nothing if the file has only a spacing. Limit: is_usable().
  std::optional<VolumePlacement> placement;
  /// The declared value of places that were not scanned.
  std::optional<double> padding;
  /// Whether the file declares that values are Hounsfield units.
  bool is_in_hounsfield = false;
  /// The labels that the file describes, including its other volumes, which are then layers of one
  /// segmentation.
  LabelTable labels;
  /// The format and its storage, for people: "NRRD, gzip".
  std::string format;
  /// The assumptions and omissions of the reader. Written by note().
  std::vector<std::string> notes;
};

// Readers and filters use these functions; set_place() of declared_place.hpp sets the place.

/// Adds a note, unless it exists.
void note(VolumeInfo& info, const std::string& text);

/// Sets sizes, the fastest axis first. Two sizes mean one slice; axes beyond the third count
/// volumes. frame: the requested volume. Throws if a size is out of the range of VolumeInfo::dims,
/// or if the frame does not exist. Limit: after the type is set.
void set_dims(VolumeInfo& info, const std::string& file, const std::vector<std::int64_t>& sizes,
              std::optional<std::uint32_t> frame = {});

/// Sets the number of channels per voxel. channel: the requested one. names: of the channels, for
/// people, or empty. Throws if the requested channel does not exist, or if there are several and
/// none is requested.
void set_channels(VolumeInfo& info, const std::string& file, std::uint64_t channels,
                  std::optional<std::uint32_t> channel, const std::vector<std::string>& names = {});

/// Sets value = slope * stored + intercept; a slope of 0 means no scaling. Throws if slope is
/// negative, or if either is not finite.
void set_scale(VolumeInfo& info, const std::string& file, double slope, double intercept);

/// Throws if a file cannot hold what it declares: small files may declare large pictures. what: "a
/// slice". Units: bytes, before any packing. expansion: the largest effect of a packing.
void require_possible(const std::string& file, const std::string& what, std::uint64_t bytes,
                      std::uint64_t expansion = 16384);

/// Selects a part of the volume, or enlarges its voxels. Voxel (0, 0, 0) has its centre at `first`,
/// and its neighbours are `step` away, so every voxel keeps its place. Units: original voxels.
/// file: for the VolumeError if the placement is then out of range.
void set_part(VolumeInfo& info, const std::string& file, const std::array<std::uint32_t, 3>& dims,
              const std::array<double, 3>& first, double step);

/// Return the bytes of one volume, and of all volumes in the file.
std::uint64_t volume_bytes(const VolumeInfo& info);
std::uint64_t bytes_of_all(const VolumeInfo& info);

/// Returns extents for a message, such as "8 x 9 x 6".
std::string extents(const std::array<std::uint32_t, 3>& dims);

/// One pass over a volume of a file. read_slice() and skip_slice() throw VolumeError after the last
/// slice, if compressed data is damaged, and if data ends early. The text then names the slice and
/// the number of missing bytes.
class VolumeReader : public SliceReader {
 public:
  const VolumeInfo& info() const override = 0;

  /// Returns assumptions and omissions so far. The last slice may add a note of what follows it.
  virtual const std::vector<std::string>& notes() const { return info().notes; }
};

/// A volume whose slices are read by index, so skipping costs nothing.
class NumberedSlices : public VolumeReader {
 public:
  const VolumeInfo& info() const final { return info_; }
  void read_slice(void* samples) final {
    require_slice_left(source_, next_, info_.dims[2]);
    read(next_, samples);
    ++next_;
  }
  void skip_slice() final {
    require_slice_left(source_, next_, info_.dims[2]);
    ++next_;
  }

 protected:
  /// source: for errors.
  NumberedSlices(std::string source, VolumeInfo info)
      : source_(std::move(source)), info_(std::move(info)) {}

  const std::string& source() const { return source_; }
  /// Returns the description; reading may add notes to it.
  VolumeInfo& own_info() { return info_; }

 private:
  /// Limit: indexes ascend.
  virtual void read(std::uint32_t slice, void* samples) = 0;

  std::string source_;
  VolumeInfo info_;
  std::uint32_t next_ = 0;
};

/// A filter that passes slices on unchanged, unless a function is overridden.
class VolumeFilter : public VolumeReader {
 public:
  const VolumeInfo& info() const final { return info_; }
  const std::vector<std::string>& notes() const final {
    if (own_notes_.empty()) return volume_->notes();
    notes_ = volume_->notes();
    notes_.insert(notes_.end(), own_notes_.begin(), own_notes_.end());
    return notes_;
  }
  void read_slice(void* samples) override { volume_->read_slice(samples); }
  void skip_slice() override { volume_->skip_slice(); }

 protected:
  explicit VolumeFilter(std::unique_ptr<VolumeReader> volume)
      : volume_(std::move(volume)), info_(volume_->info()) {}

  VolumeReader& volume() const { return *volume_; }
  /// Returns the filter's own description, initially a copy of the volume's.
  VolumeInfo& own_info() { return info_; }
  /// Adds a note behind the volume's notes.
  void add_note(const std::string& text) { own_notes_.push_back(text); }

 private:
  std::unique_ptr<VolumeReader> volume_;
  VolumeInfo info_;
  std::vector<std::string> own_notes_;
  mutable std::vector<std::string> notes_;
};

}  // namespace discmc::command
