// Receives a stream of regions, or of slices with fractions, as a surface with its crossings.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include <discmc/byte_output.hpp>
#include <discmc/sink.hpp>

#include "samples/spacing.hpp"
#include "streams/sent_fractions.hpp"
#include "streams/stream_reader.hpp"
#include "surface/joined_surface.hpp"

/// An output that appends to the bytes. Owner: the caller.
inline discmc::ByteOutput output_to(std::vector<std::uint8_t>& bytes) {
  return {&bytes, [](void* context, const std::uint8_t* written, std::size_t count) {
            auto& all = *static_cast<std::vector<std::uint8_t>*>(context);
            all.insert(all.end(), written, written + count);
            return count;
          }};
}

class ReceivedFractions {
 public:
  explicit ReceivedFractions(const std::vector<std::uint8_t>& bytes)
      : reader_(discmc::make_sink(*this)) {
    reader_.push(bytes.data(), bytes.size());
    reader_.finish();
    joined_.finish();
    joined_.surface().spacing_mm = discmc::meshing::spacing_mm(reader_.header());
  }
  ReceivedFractions(const ReceivedFractions&) = delete;
  ReceivedFractions& operator=(const ReceivedFractions&) = delete;

  discmc::SinkResult accept(const discmc::Event& event) {
    fractions_.accept(event);
    return joined_.accept(event);
  }

  bool is_complete() const { return reader_.report().is_complete(); }
  const discmc::meshing::Surface& surface() const { return joined_.surface(); }
  discmc::meshing::Crossings crossings() const {
    discmc::meshing::Crossings crossings(reader_.dims(), surface().polygons);
    fractions_.place(crossings);
    return crossings;
  }

 private:
  discmc::meshing::JoinedSurface joined_;
  discmc::meshing::SentFractions fractions_;
  discmc::meshing::StreamReader reader_;
};
