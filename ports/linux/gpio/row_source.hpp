// The source of the samples of a row, after its edge.
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "samples/sample_type.hpp"

namespace discmc::device {

class RowSource {
 public:
  RowSource() = default;
  RowSource(const RowSource&) = delete;
  RowSource& operator=(const RowSource&) = delete;
  virtual ~RowSource() = default;

  /// Reads the row with this number, 16-bit samples with the low byte first. False when there is
  /// none any more, or when the program must stop. row: Size: a row, owned by the caller. Throws
  /// DeviceGone.
  virtual bool read(std::uint32_t number, std::vector<std::uint8_t>& row) = 0;
};

/// A file holds the rows by their numbers, missed ones too. Anything else that can be read, a
/// device or a pipe ("-" is standard input), gives the row that its sensor holds. It is the next
/// one, whatever its number. Throws std::runtime_error when it cannot be opened.
std::unique_ptr<RowSource> open_rows(const std::string& path);

/// A generated volume: a ball with a hole through it, in noise.
std::unique_ptr<RowSource> simulated_rows(const std::array<std::uint32_t, 3>& dims,
                                          meshing::SampleType type);

}  // namespace discmc::device
