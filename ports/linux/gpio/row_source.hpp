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

  /// Reads the row with this number; 16-bit samples are little-endian. Returns false after the last
  /// row, or if the program must stop. row: Size: a row, owned by the caller. Throws DeviceGone.
  virtual bool read(std::uint32_t number, std::vector<std::uint8_t>& row) = 0;
};

/// A file contains the rows by their numbers, including missed ones. A device or a pipe ("-" is
/// standard input) returns the next row of its sensor for any number. Throws std::runtime_error if
/// it cannot be opened.
std::unique_ptr<RowSource> open_rows(const std::string& path);

/// A generated volume: a ball with a hole through it, in noise.
std::unique_ptr<RowSource> simulated_rows(const std::array<std::uint32_t, 3>& dims,
                                          meshing::SampleType type);

}  // namespace discmc::device
