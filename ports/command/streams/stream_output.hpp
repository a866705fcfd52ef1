// The stream (.dmc) that an encoder writes.
#pragma once

#include <cstddef>
#include <cstdint>
#include <ostream>

#include <discmc/encoder.hpp>

namespace discmc::command {

/// An output that passes an encoder's bytes to a stream and counts them. Owner: `out` belongs to
/// the caller and outlives the output.
class StreamOutput {
 public:
  explicit StreamOutput(std::ostream* out) : out_(out) {}
  ByteOutput byte_output() {
    return {this, [](void* context, const std::uint8_t* bytes, std::size_t count) {
              auto& self = *static_cast<StreamOutput*>(context);
              self.out_->write(reinterpret_cast<const char*>(bytes),
                               static_cast<std::streamsize>(count));
              self.bytes_ += count;
              return count;
            }};
  }
  std::uint64_t bytes() const { return bytes_; }

 private:
  std::ostream* out_;
  std::uint64_t bytes_ = 0;
};

}  // namespace discmc::command
