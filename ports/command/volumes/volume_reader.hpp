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

  /// What was assumed or left out so far. The last slice may add what follows it.
  virtual const std::vector<std::string>& notes() const { return info().notes; }

  /// Writes the next slice, rows of x from y = 0, samples in native byte order.
  /// Size: info().slice_bytes(), owned by the caller.
  /// Throws VolumeError when the data ends early (the text names the slice and how many bytes
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

}  // namespace discmc::command

#endif
