// A volume as it is read, wherever its slices come from.
#ifndef DISCMC_COMMAND_VOLUMES_VOLUME_READER_HPP
#define DISCMC_COMMAND_VOLUMES_VOLUME_READER_HPP

#include <cstdint>
#include <string>
#include <vector>

#include "volume_error.hpp"
#include "volume_info.hpp"

namespace discmc::command {

/// One pass over a volume, first slice to last.
class VolumeReader {
 public:
  VolumeReader() = default;
  VolumeReader(const VolumeReader&) = delete;
  VolumeReader& operator=(const VolumeReader&) = delete;
  virtual ~VolumeReader() = default;

  /// Valid as long as the reader.
  virtual const VolumeInfo& info() const = 0;

  /// What was assumed or left out so far. The last slice may add what stands behind it.
  virtual const std::vector<std::string>& notes() const { return info().notes; }

  /// Writes the next slice, rows of x from y = 0, samples in native byte order.
  /// Size: info().slice_bytes(), owned by the caller.
  /// Throws VolumeError when the data ends early (the text says in which slice and how many bytes
  /// are missing), when compressed data is damaged, and after the last slice. What a failed call
  /// wrote has no meaning.
  virtual void read_slice(void* samples) = 0;

  /// Goes past the next slice, without reading it where the file allows. Throws as read_slice(), of
  /// what it comes by.
  virtual void skip_slice() {
    std::vector<std::uint8_t> dropped(info().slice_bytes());
    read_slice(dropped.data());
  }
};

/// The iso value, less what decimal numbers may have lost when they were rounded on their way here:
/// what is not below this reaches iso.
double lowered_by_rounding(const VolumeInfo& info, double iso);

/// The threshold on stored samples that stands for an iso value in the file's declared units:
/// stored >= threshold exactly where value >= iso. Values that differ from iso by no more than the
/// rounding of the decimal numbers involved count as equal, so iso 0.9 at slope 0.3 is 3, not 4.
/// Saturates: INT32_MIN when every value reaches iso, INT32_MAX when none does (or iso is NaN).
/// Of samples that are not whole numbers it is the first whole one.
std::int32_t stored_threshold(const VolumeInfo& info, double iso);

}  // namespace discmc::command

#endif
