// The surface of the received part of a stream (.dmc).
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include <discmc/placement.hpp>

#include "missing.hpp"
#include "streams/sent_fractions.hpp"
#include "streams/stream_reader.hpp"
#include "surface/joined_surface.hpp"

namespace discmc::web {

/// The surface of a stream of either kind; on a link with several surfaces, one of them.
class StreamSurface {
 public:
  explicit StreamSurface(const meshing::StreamChoice& choice);
  StreamSurface(const StreamSurface&) = delete;
  StreamSurface& operator=(const StreamSurface&) = delete;

  SinkResult accept(const Event& event);
  /// Throws like StreamReader::push().
  void push(const std::uint8_t* bytes, std::size_t count);
  /// Limit: the last call. Throws like StreamReader::finish().
  void finish();

  const meshing::StreamReader& reader() const { return reader_; }
  /// The placement of the volume, if the stream has one.
  const std::optional<Placement>& placement() const { return placement_; }
  /// Regions with missing pieces count as lost.
  StreamReport report() const;
  /// Its spacing is that of the stream.
  const meshing::Surface& surface() const { return surface_.surface(); }
  const meshing::Polygons& polygons() const { return surface().polygons; }
  const meshing::SentFractions& fractions() const { return fractions_; }
  /// The positions of missing rows, and after finish() of missing polygons.
  Missing missing(bool is_end) const;

 private:
  void note_skipped(std::uint32_t slice, std::uint32_t row);

  meshing::JoinedSurface surface_;
  meshing::SentFractions fractions_;
  meshing::StreamReader reader_;
  std::optional<Placement> placement_;
  std::vector<MissingRows> rows_;  // the first of the skipped rows
};

}  // namespace discmc::web
