#include "stream_output.hpp"

namespace discmc::command {

ByteOutput StreamOutput::byte_output() {
  return {this, [](void* context, const std::uint8_t* bytes, std::size_t count) {
            auto& self = *static_cast<StreamOutput*>(context);
            self.out_->write(reinterpret_cast<const char*>(bytes),
                             static_cast<std::streamsize>(count));
            self.bytes_ += count;
            return count;
          }};
}

}  // namespace discmc::command
