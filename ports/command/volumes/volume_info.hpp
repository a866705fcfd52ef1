// What is known of a volume of a file, how its slices are read, and volumes made of another one.
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "label_description.hpp"
#include "meshing.hpp"
#include "samples/slice_reader.hpp"
#include "samples/volume_placement.hpp"
#include "volume_error.hpp"

namespace discmc::command {

/// The description of a volume in its file. An oblique left-handed volume has a negative spacing
/// along z, so that no shape is ever mirrored, and the placement only turns and moves it.
struct VolumeInfo : SampleGrid {
  /// The extents before a part was taken, or the volume was shrunk. Units: voxels.
  std::optional<std::array<std::uint32_t, 3>> whole_dims;
  /// The number of volumes in the file, of which this is one: 3D volumes of a 4D one.
  std::uint64_t frames = 1;
  /// The number of samples that the file holds of a voxel, of which this is one: colours, stains.
  std::uint64_t channels = 1;
  /// Where the volume lies; nothing if the file has only a spacing.
  /// Limit: is_usable().
  std::optional<VolumePlacement> placement;
  /// The value where nothing was scanned, if the file declares one.
  std::optional<double> padding;
  /// Whether the file declares that values are Hounsfield units.
  bool is_in_hounsfield = false;
  /// The labels that the file describes, also those in its other volumes. Then these are layers of
  /// one segmentation.
  LabelTable labels;
  /// The format and the way it is stored, for people: "NRRD, gzip".
  std::string format;
  /// What the reader assumed, and what it left out of the file. Written by note().
  std::vector<std::string> notes;
};

// Readers and filters fill it with these; set_place() of declared_place.hpp sets its place.

/// Adds a note, unless it is there.
void note(VolumeInfo& info, const std::string& text);

/// Takes sizes, fastest axis first. Two give one slice; those beyond the third count volumes.
/// frame: the one of them that is asked for. Throws when a size is out of the range of
/// VolumeInfo::dims, and when the file does not hold the frame. Limit: after the type.
void set_dims(VolumeInfo& info, const std::string& file, const std::vector<std::int64_t>& sizes,
              std::optional<std::uint32_t> frame = {});

/// Takes how many channels a voxel has. channel: the one that is asked for. names: of the channels,
/// for people, or none. Throws when the one asked for is not among them, and when there are several
/// and none is asked for.
void set_channels(VolumeInfo& info, const std::string& file, std::uint64_t channels,
                  std::optional<std::uint32_t> channel, const std::vector<std::string>& names = {});

/// Takes value = slope * stored + intercept; a slope of 0 means no scaling. Throws when
/// slope is negative or either not finite.
void set_scale(VolumeInfo& info, const std::string& file, double slope, double intercept);

/// Selects a part of the volume, or makes its voxels larger. Voxel (0, 0, 0) has its centre at
/// `first`, and the next ones are `step` away. Every voxel then lies where it was. Units: voxels
/// before. The file is for the VolumeError thrown where that is out of the range of a placement.
void set_part(VolumeInfo& info, const std::string& file, const std::array<std::uint32_t, 3>& dims,
              const std::array<double, 3>& first, double step);

/// Units: bytes of one volume, and of all in the file.
std::uint64_t volume_bytes(const VolumeInfo& info);
std::uint64_t bytes_of_all(const VolumeInfo& info);

/// Returns the extents of a volume for a message, as in "8 x 9 x 6".
std::string extents(const std::array<std::uint32_t, 3>& dims);

/// One pass over a volume of a file. read_slice() and skip_slice() throw VolumeError if compressed
/// data is damaged, after the last slice, and if the data ends early. The text then names the slice
/// and the number of missing bytes.
class VolumeReader : public SliceReader {
 public:
  const VolumeInfo& info() const override = 0;

  /// What was assumed or left out so far. The last slice may add what follows it.
  virtual const std::vector<std::string>& notes() const { return info().notes; }
};

/// A volume whose slices are read by their numbers: one that is skipped costs nothing.
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
  /// Reading may add notes.
  VolumeInfo& own_info() { return info_; }

 private:
  /// Limit: numbers that rise.
  virtual void read(std::uint32_t slice, void* samples) = 0;

  std::string source_;
  VolumeInfo info_;
  std::uint32_t next_ = 0;
};

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
