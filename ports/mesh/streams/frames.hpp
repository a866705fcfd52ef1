// Splits the bytes of a link into frames.
#ifndef DISCMC_MESH_STREAMS_FRAMES_HPP
#define DISCMC_MESH_STREAMS_FRAMES_HPP

#include <cstddef>
#include <cstdint>
#include <vector>

#include <discmc/stream/wire.hpp>

namespace discmc::meshing {

class Frames {
 public:
  /// Calls receive(frame) for every frame that ends in these bytes, including its zero. A frame too
  /// long for a packet is cut, to bound memory.
  template <class Receive>
  void push(const std::uint8_t* bytes, std::size_t count, Receive receive) {
    for (std::size_t i = 0; i < count; ++i) {
      if (frame_.size() <= detail::wire::max_frame || bytes[i] == 0) frame_.push_back(bytes[i]);
      if (bytes[i] != 0) continue;
      receive(static_cast<const std::vector<std::uint8_t>&>(frame_));
      frame_.clear();
    }
  }

 private:
  std::vector<std::uint8_t> frame_;
};

}  // namespace discmc::meshing

#endif
