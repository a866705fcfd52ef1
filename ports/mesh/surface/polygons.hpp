// Merged polygons on the half-step lattice, all of them together in a few arrays.
#ifndef DISCMC_MESH_SURFACE_POLYGONS_HPP
#define DISCMC_MESH_SURFACE_POLYGONS_HPP

#include <cstddef>
#include <cstdint>
#include <stdexcept>
#include <string>
#include <vector>

#include <discmc/lattice.hpp>

namespace discmc::meshing {

/// A simple ring by its corners: from each a straight side of links leads to the next, and from the
/// last to the first. No vertex of a link is there twice. Units: half-steps. Owner: who has the
/// corners.
class Ring {
 public:
  Ring(const Vertex* begin, const Vertex* end) : begin_(begin), end_(end) {}

  const Vertex* begin() const { return begin_; }
  const Vertex* end() const { return end_; }
  const Vertex* data() const { return begin_; }
  std::size_t size() const { return static_cast<std::size_t>(end_ - begin_); }
  const Vertex& operator[](std::size_t corner) const { return begin_[corner]; }

 private:
  const Vertex* begin_;
  const Vertex* end_;
};

/// The rings of a polygon. Owner: Polygons.
class Rings {
 public:
  class Iterator {
   public:
    Iterator(const Vertex* corners, const std::uint32_t* begin)
        : corners_(corners), begin_(begin) {}

    Ring operator*() const { return {corners_ + begin_[0], corners_ + begin_[1]}; }
    Iterator& operator++() {
      ++begin_;
      return *this;
    }
    bool operator!=(const Iterator& other) const { return begin_ != other.begin_; }

   private:
    const Vertex* corners_;       // of all polygons
    const std::uint32_t* begin_;  // where in them the ring begins; then, where the next one does
  };

  Rings(const Vertex* corners, const std::uint32_t* begins, std::size_t size)
      : corners_(corners), begins_(begins), size_(size) {}

  Iterator begin() const { return {corners_, begins_}; }
  Iterator end() const { return {corners_, begins_ + size_}; }
  std::size_t size() const { return size_; }
  Ring operator[](std::size_t ring) const { return *Iterator(corners_, begins_ + ring); }

 private:
  const Vertex* corners_;
  const std::uint32_t* begins_;
  std::size_t size_;
};

/// A region as rings in the plane of its incidence: the outer ring first, counter-clockwise seen
/// from the tip of the normal, then the holes, clockwise. Rings may touch in a vertex; they never
/// cross and never share a link. Owner: Polygons, until more are added.
struct Polygon {
  discmc::Incidence incidence;
  Rings rings;
};

/// Throws std::length_error where corners are more than 32 bits count.
inline void require_numbers_for(std::size_t corners) {
  constexpr std::size_t most = 0xFFFFFFFFu;
  if (corners > most)
    throw std::length_error("the surface has more than " + std::to_string(most) +
                            " corners, the limit of a mesh; extract a part, or shrink the volume");
}

/// Polygons one behind the other. Limit: fewer than 2^32 corners, else std::length_error.
class Polygons {
 public:
  class Iterator {
   public:
    Iterator(const Polygons& polygons, std::size_t place) : polygons_(&polygons), place_(place) {}

    Polygon operator*() const { return (*polygons_)[place_]; }
    Iterator& operator++() {
      ++place_;
      return *this;
    }
    bool operator!=(const Iterator& other) const { return place_ != other.place_; }

   private:
    const Polygons* polygons_;
    std::size_t place_;
  };

  Iterator begin() const { return {*this, 0}; }
  Iterator end() const { return {*this, size()}; }
  std::size_t size() const { return incidences_.size(); }
  bool empty() const { return incidences_.empty(); }
  Polygon operator[](std::size_t place) const {
    const std::uint32_t* begins = ring_begins_.data() + polygon_begins_[place];
    return {incidences_[place],
            {corners_.data(), begins, polygon_begins_[place + 1] - polygon_begins_[place]}};
  }

  /// The corners of all rings, in order.
  const std::vector<Vertex>& corners() const { return corners_; }
  /// Where the corners of a polygon begin; for place size(), where they end.
  std::size_t first_corner(std::size_t place) const { return ring_begins_[polygon_begins_[place]]; }

  /// Adds a polygon that has no ring yet.
  void add_polygon(Incidence incidence) {
    incidences_.push_back(incidence);
    polygon_begins_.push_back(polygon_begins_.back());
  }
  /// Adds a ring to the last polygon. ring: none of these polygons.
  void add_ring(const Ring& ring) {
    require_numbers_for(corners_.size() + ring.size());
    corners_.insert(corners_.end(), ring.begin(), ring.end());
    ring_begins_.push_back(static_cast<std::uint32_t>(corners_.size()));
    ++polygon_begins_.back();
  }
  /// Adds one of others.
  void push_back(const Polygon& polygon) {
    add_polygon(polygon.incidence);
    for (const Ring& ring : polygon.rings) add_ring(ring);
  }
  /// Adds all of others.
  void append(const Polygons& others) {
    require_numbers_for(corners_.size() + others.corners_.size());
    append_begins(polygon_begins_, others.polygon_begins_);
    append_begins(ring_begins_, others.ring_begins_);
    incidences_.insert(incidences_.end(), others.incidences_.begin(), others.incidences_.end());
    corners_.insert(corners_.end(), others.corners_.begin(), others.corners_.end());
  }

 private:
  using Begins = std::vector<std::uint32_t>;

  // The first begins where the last ends.
  static void append_begins(Begins& begins, const Begins& others) {
    const std::size_t kept = begins.size();
    const std::uint32_t end = begins.back();
    begins.insert(begins.end(), others.begin() + 1, others.end());
    for (std::size_t i = kept; i < begins.size(); ++i) begins[i] += end;
  }

  std::vector<Incidence> incidences_;
  Begins polygon_begins_{0};  // in ring_begins_; one more than polygons
  Begins ring_begins_{0};     // in corners_; one more than rings
  std::vector<Vertex> corners_;
};

}  // namespace discmc::meshing

#endif
