// A volume as it is read, wherever its slices come from.
#ifndef DISCMC_COMMAND_VOLUMES_VOLUME_READER_HPP
#define DISCMC_COMMAND_VOLUMES_VOLUME_READER_HPP

#include <cstdint>
#include <string>
#include <vector>

#include "volume_error.hpp"
#include "volume_info.hpp"

namespace discmc::command {

/// One pass over a volume of a file. read_slice() and skip_slice() throw VolumeError if compressed
/// data is damaged, after the last slice, and if the data ends early. The text then names the slice
/// and the number of missing bytes.
class VolumeReader : public SliceReader {
 public:
  const VolumeInfo& info() const override = 0;

  /// What was assumed or left out so far. The last slice may add what follows it.
  virtual const std::vector<std::string>& notes() const { return info().notes; }
};

}  // namespace discmc::command

#endif
