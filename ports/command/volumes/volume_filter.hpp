// A volume made of another one.
#pragma once

#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "volume_info.hpp"

namespace discmc::command {

/// The same slices: what a filter does not override stays as it is.
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
  /// A filter that is another volume changes this. At first it is that of the volume.
  VolumeInfo& own_info() { return info_; }
  /// Behind the notes of the volume.
  void add_note(const std::string& text) { own_notes_.push_back(text); }

 private:
  std::unique_ptr<VolumeReader> volume_;
  VolumeInfo info_;
  std::vector<std::string> own_notes_;
  mutable std::vector<std::string> notes_;
};

}  // namespace discmc::command
