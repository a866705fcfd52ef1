// Converts surfaces to events with loose fragments, as a sweep may send them, and back.
#pragma once

#include <algorithm>
#include <cstdint>
#include <functional>
#include <string>
#include <utility>
#include <vector>

#include "event_log.hpp"
#include "region.hpp"

namespace discmc::reference {

/// The events of a region or a loose fragment, from the first to the last.
struct Piece {
  Events events;
  size_t rank = 0;    ///< its position in a sweep
  size_t region = 0;  ///< index of its region or fragment
  size_t ring = 0;    ///< index in the region, for a fragment
  size_t place = 0;   ///< index among the ring's fragments
  size_t places = 0;
  size_t stream = 0;

  bool is_fragment() const { return events.front().is(Event::Kind::fragment); }
};

using Pieces = std::vector<Piece>;
using Below = std::function<uint32_t(uint32_t limit)>;

/// The parameters by which the rings of a surface are cut.
struct Cuts {
  Below below;                 ///< random source: a number below the limit
  uint32_t loose_outers = 50;  ///< percent of the outer rings
  uint32_t loose_holes = 50;   ///< percent of the other regions' holes
  uint32_t max_pieces = 5;     ///< per ring
  int32_t slab = 0;            ///< height of the slabs, each a stream; 0: one for all.
                               ///< Units: half-steps
};

/// Returns a normal that depends only on the vertex, so that a wrong one is detected.
inline OctahedralNormal normal_at(const Vertex& vertex) {
  const auto mixed = static_cast<uint32_t>(vertex.x * 73 + vertex.y * 151 + vertex.z * 283);
  return {static_cast<uint8_t>(1 + mixed % 255), static_cast<uint8_t>(mixed / 255)};
}

inline Vertex highest(const Ring& ring) {
  return *std::max_element(ring.begin(), ring.end(), before);
}

/// Cuts the rings of a surface. The pieces have the order of a sweep, and pieces of other streams
/// are interleaved.
class Cutter {
 public:
  Cutter(const std::vector<Region>& regions, Cuts cuts)
      : regions_(regions), cuts_(std::move(cuts)) {
    rank_rings();
    for (size_t region = 0; region < regions_.size(); ++region) add_region(region);
    std::stable_sort(pieces_.begin(), pieces_.end(),
                     [](const Piece& a, const Piece& b) { return a.rank < b.rank; });
  }

  Pieces pieces() const { return pieces_; }

 private:
  struct RingName {
    size_t region, ring;
  };

  const Ring& ring_of(const RingName& name) const { return regions_[name.region].rings[name.ring]; }

  // Ranks inner polygons before the outer ones around them.
  void rank_rings() {
    std::vector<RingName> names;
    for (size_t region = 0; region < regions_.size(); ++region)
      for (size_t ring = 0; ring < regions_[region].rings.size(); ++ring)
        names.push_back({region, ring});
    const auto area = [&](const RingName& name) {
      const int64_t signed_one = signed_area(regions_[name.region].incidence, ring_of(name));
      return signed_one < 0 ? -signed_one : signed_one;
    };
    std::sort(names.begin(), names.end(), [&](const RingName& a, const RingName& b) {
      const Vertex top_a = highest(ring_of(a)), top_b = highest(ring_of(b));
      return top_a != top_b ? before(top_a, top_b) : area(a) < area(b);
    });
    for (const Region& region : regions_) ranks_.emplace_back(region.rings.size());
    for (size_t rank = 0; rank < names.size(); ++rank)
      ranks_[names[rank].region][names[rank].ring] = rank;
  }

  // Returns the slab that sends a link.
  size_t stream_of(const Vertex& from, const Vertex& to) const {
    return cuts_.slab == 0 ? 0 : static_cast<size_t>((std::max(from.z, to.z) + 2) / cuts_.slab);
  }

  bool has_chance(uint32_t percent) const { return cuts_.below(100) < percent; }

  void add_region(size_t region) {
    const std::vector<Ring>& rings = regions_[region].rings;
    const Ring& outer = rings[0];
    const size_t stream = stream_of(outer[0], outer[1 % outer.size()]);
    bool is_loose = has_chance(cuts_.loose_outers);
    for (size_t i = 0; i < outer.size(); ++i)
      is_loose = is_loose || stream_of(outer[i], outer[(i + 1) % outer.size()]) != stream;
    Piece piece;
    piece.rank = ranks_[region][0];
    piece.region = region;
    piece.stream = stream;
    add(piece, region, Event::Kind::region);
    for (size_t ring = 0; ring < rings.size(); ++ring) {
      if (is_loose || (ring > 0 && has_chance(cuts_.loose_holes)))
        add_pieces({region, ring});
      else
        add_ring(piece, {region, ring});
    }
    if (is_loose) return;
    add(piece, region, Event::Kind::region_end);
    pieces_.push_back(std::move(piece));
  }

  void add(Piece& piece, size_t region, Event::Kind kind) const {
    add(piece, region, kind, [](Event&) {});
  }
  template <class Fill>
  void add(Piece& piece, size_t region, Event::Kind kind, Fill fill) const {
    Event event{};
    event.kind = kind;
    event.incidence = regions_[region].incidence;
    fill(event);
    piece.events.emplace_back(event);
  }

  Direction direction(const RingName& name, size_t link) const {
    const Ring& ring = ring_of(name);
    const Vertex step = ring[(link + 1) % ring.size()] - ring[link % ring.size()];
    return direction_of(regions_[name.region].incidence, step);
  }
  bool is_corner(const RingName& name, size_t vertex) const {
    return direction(name, vertex) != direction(name, vertex + ring_of(name).size() - 1);
  }

  // Adds the runs of `count` links from a vertex on.
  void add_runs(Piece& piece, const RingName& name, size_t first, size_t count) const {
    const Ring& ring = ring_of(name);
    for (size_t link = first; link < first + count;) {
      uint32_t length = 1;
      while (link + length < first + count && !is_corner(name, link + length)) ++length;
      add(piece, name.region, Event::Kind::run, [&](Event& event) {
        event.run = Run::straight(direction(name, link), length);
        event.normal = normal_at(ring[link % ring.size()]);
      });
      link += length;
    }
  }

  void add_ring(Piece& piece, const RingName& name) const {
    size_t first = 0;
    while (!is_corner(name, first)) ++first;
    add(piece, name.region, Event::Kind::ring, [&](Event& event) {
      event.start = ring_of(name)[first];
      event.is_hole = name.ring > 0;
    });
    add_runs(piece, name, first, ring_of(name).size());
  }

  // Returns cuts at the seams between slabs, and at random places.
  std::vector<size_t> cut_vertices(const RingName& name) const {
    const Ring& ring = ring_of(name);
    std::vector<size_t> places;
    for (size_t i = 0; i < ring.size(); ++i) {
      const Vertex& last = ring[(i + ring.size() - 1) % ring.size()];
      if (stream_of(last, ring[i]) != stream_of(ring[i], ring[(i + 1) % ring.size()]))
        places.push_back(i);
    }
    for (uint32_t more = 1 + cuts_.below(cuts_.max_pieces); more > 0; --more)
      places.push_back(cuts_.below(static_cast<uint32_t>(ring.size())));
    std::sort(places.begin(), places.end());
    places.erase(std::unique(places.begin(), places.end()), places.end());
    return places;
  }

  // One of the pieces is sent when the ring is complete, the others some time before.
  void add_pieces(const RingName& name) {
    const Ring& ring = ring_of(name);
    const std::vector<size_t> places = cut_vertices(name);
    const size_t rank = ranks_[name.region][name.ring];
    const size_t last = cuts_.below(static_cast<uint32_t>(places.size()));
    for (size_t i = 0; i < places.size(); ++i) {
      const size_t begin = places[i];
      const size_t end = i + 1 < places.size() ? places[i + 1] : places[0] + ring.size();
      Piece piece;
      const size_t earlier = std::min<size_t>(rank, cuts_.below(50));
      piece.rank = i == last ? rank : rank - earlier;
      piece.region = name.region;
      piece.ring = name.ring;
      piece.place = i;
      piece.places = places.size();
      piece.stream = stream_of(ring[begin], ring[(begin + 1) % ring.size()]);
      add(piece, name.region, Event::Kind::fragment, [&](Event& event) {
        event.start = ring[begin];
        event.incoming_direction = direction(name, begin + ring.size() - 1);
      });
      add_runs(piece, name, begin, end - begin);
      add(piece, name.region, Event::Kind::fragment_end);
      pieces_.push_back(std::move(piece));
    }
  }

  const std::vector<Region>& regions_;
  Cuts cuts_;
  std::vector<std::vector<size_t>> ranks_;  // by region and ring
  Pieces pieces_;
};

inline Pieces cut(const std::vector<Region>& regions, const Cuts& cuts) {
  return Cutter(regions, cuts).pieces();
}

/// Shuffles pieces into any order.
inline void shuffle(Pieces& pieces, const Below& below) {
  for (size_t i = pieces.size(); i > 1; --i)
    std::swap(pieces[i - 1], pieces[below(static_cast<uint32_t>(i))]);
}

/// Interleaves the pieces of several streams at random; each stream keeps its order.
inline Pieces interleaved(const Pieces& pieces, const Below& below) {
  std::vector<Pieces> streams;
  for (const Piece& piece : pieces) {
    if (streams.size() <= piece.stream) streams.resize(piece.stream + 1);
    streams[piece.stream].push_back(piece);
  }
  for (Pieces& stream : streams) std::reverse(stream.begin(), stream.end());
  Pieces dealt;
  while (dealt.size() < pieces.size()) {
    Pieces& stream = streams[below(static_cast<uint32_t>(streams.size()))];
    if (stream.empty()) continue;
    dealt.push_back(std::move(stream.back()));
    stream.pop_back();
  }
  return dealt;
}

inline Events events_of(const Pieces& pieces) {
  Events events;
  for (const Piece& piece : pieces)
    events.insert(events.end(), piece.events.begin(), piece.events.end());
  return events;
}

/// Splits the events of a sink into pieces. Errors: throws GrammarError, also if a run of a region
/// starts at no corner, or has the normal of another place.
class Delivered {
 public:
  explicit Delivered(const Events& events) {
    for (const RecordedEvent& recorded : events) add(recorded);
    require(piece_.empty(), "a piece without end");
  }

  std::vector<Region> regions;
  Pieces fragments;
  Events marks;  ///< all other events

 private:
  static void require(bool holds, const char* broken) {
    if (!holds) throw GrammarError(broken);
  }

  void add(const RecordedEvent& recorded) {
    const Event event = recorded.event();
    const bool is_begin = recorded.is(Event::Kind::region) || recorded.is(Event::Kind::fragment);
    if (piece_.empty() && !is_begin) {
      require(!recorded.is(Event::Kind::ring) && !recorded.is(Event::Kind::run) &&
                  !recorded.is(Event::Kind::region_end) && !recorded.is(Event::Kind::fragment_end),
              "part of a piece, outside any");
      marks.push_back(recorded);
      return;
    }
    require(piece_.empty() == is_begin, "a piece within another");
    const bool is_in_region =
        is_begin ? recorded.is(Event::Kind::region) : piece_.front().is(Event::Kind::region);
    piece_.push_back(recorded);
    switch (event.kind) {
      case Event::Kind::region:
        region_ = {event.incidence, {}};
        return;
      case Event::Kind::ring:
        require(is_in_region && event.is_hole == !region_.rings.empty(),
                "a ring in the wrong place");
        end_ring();
        region_.rings.emplace_back();
        start_ = at_ = event.start;
        return;
      case Event::Kind::fragment:
        region_ = {event.incidence, {{}}};
        start_ = at_ = event.start;
        return;
      case Event::Kind::run:
        return add_run(event);
      case Event::Kind::region_end:
        require(is_in_region, "a fragment that ends as a region");
        end_ring();
        regions.push_back(region_);
        break;
      case Event::Kind::fragment_end:
        require(!is_in_region && !runs_.empty(), "no fragment, or an empty one");
        runs_.clear();
        fragments.push_back({piece_});
        break;
      default:
        require(false, "a mark within a piece");
    }
    piece_.clear();
  }

  void add_run(const Event& event) {
    require(!region_.rings.empty(), "a run outside a ring");
    require(event.normal == normal_at(at_), "a normal of another vertex");
    runs_.push_back(event.run);
    const Vertex step = direction_vector(region_.incidence, event.run.direction());
    for (uint32_t i = 0; i < event.run.length(); ++i) {
      region_.rings.back().push_back(at_);
      at_ = at_ + step;
    }
  }

  void end_ring() {
    if (region_.rings.empty()) return;
    require(!runs_.empty() && at_ == start_, "a ring that is not closed");
    for (size_t i = 0; i < runs_.size(); ++i)
      require(runs_[i].direction() != runs_[(i + 1) % runs_.size()].direction(),
              "a run that starts at no corner");
    runs_.clear();
  }

  Events piece_;
  Region region_{};
  Vertex start_{}, at_{};
  std::vector<Run> runs_;  // of the current ring or fragment
};

}  // namespace discmc::reference
