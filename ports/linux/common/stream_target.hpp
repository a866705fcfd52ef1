// Where the stream of a device goes: a file that grows while the scan runs, or standard output.
#pragma once

#include <discmc/encoder.hpp>
#include <fstream>
#include <string>

#include "streams/stream_output.hpp"

namespace discmc::device {

/// Written in place, so that what was scanned is there whatever ends the program.
class StreamTarget {
 public:
  /// path: "-" is standard output, but no terminal. Throws std::runtime_error.
  explicit StreamTarget(const std::string& path);

  ByteOutput output() { return stream_.byte_output(); }

  /// Hands everything on. Throws std::runtime_error when something could not be written.
  void flush();

 private:
  std::string path_;
  std::ofstream file_;
  std::ostream* out_;
  command::StreamOutput stream_;
};

}  // namespace discmc::device
