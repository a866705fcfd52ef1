// Streams (.dmc) as files: written through an encoder, read through a decoder.
#ifndef DISCMC_HOST_STREAM_FILE_HPP
#define DISCMC_HOST_STREAM_FILE_HPP

#include <array>
#include <cstdint>
#include <functional>
#include <istream>
#include <memory>
#include <ostream>

#include <discmc/encoder.hpp>
#include <discmc/surface_decoder.hpp>

namespace discmc::host {

/// An output that counts what an encoder gives it and passes it on to a stream, if there is one.
/// Owner: `out` belongs to the caller and outlives the output.
class StreamOutput {
 public:
  explicit StreamOutput(std::ostream* out) : out_(out) {}
  ByteOutput byte_output();
  std::uint64_t bytes() const { return bytes_; }

 private:
  std::ostream* out_;
  std::uint64_t bytes_ = 0;
};

/// A stream of either kind, read to its end.
class StreamReader {
 public:
  /// sink: it must not say "not now".
  explicit StreamReader(const Sink& sink);
  /// progress: called now and then with the bytes read so far.
  /// Throws std::runtime_error when the stream's version is not known.
  void read(std::istream& in, const std::function<void(std::uint64_t)>& progress = {});

  const StreamHeader& header() const { return decoder_.header(); }
  const StreamReport& report() const { return decoder_.report(); }

 private:
  void push(const std::uint8_t* bytes, std::size_t count);
  Status give_memory();

  SurfaceDecoder decoder_{};
  std::unique_ptr<std::uint8_t[]> memory_;  // for a stream of bits
  Status status_ = Status::ok;
};

/// The spacing as headers hold it. Throws std::invalid_argument beyond their range.
std::array<std::int32_t, 3> spacing_nm(const std::array<double, 3>& spacing_mm);

/// The header's spacing, 1 where the stream does not say. Units: millimetres.
std::array<double, 3> spacing_mm(const StreamHeader& header);

}  // namespace discmc::host

#endif
