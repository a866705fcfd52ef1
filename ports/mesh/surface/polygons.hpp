// Merged polygons on the half-step lattice, stored together in a few arrays.
#ifndef DISCMC_MESH_SURFACE_POLYGONS_HPP
#define DISCMC_MESH_SURFACE_POLYGONS_HPP

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <stdexcept>
#include <string>

#include <discmc/lattice.hpp>

#include "array.hpp"

namespace discmc::meshing {

/// A simple ring by its corners. A straight side of links leads from each corner to the next, and
/// from the last to the first. No vertex of a link recurs. Units: half-steps. Owner: the owner of
/// the corners.
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

/// The least and the greatest coordinates of some vertices.
struct VertexBox {
  Vertex low, high;
};

/// Limit: at least one vertex.
inline VertexBox box_around(const Vertex* begin, const Vertex* end) {
  VertexBox box{*begin, *begin};
  for (const Vertex* each = begin; each != end; ++each) {
    box.low = {std::min(box.low.x, each->x), std::min(box.low.y, each->y),
               std::min(box.low.z, each->z)};
    box.high = {std::max(box.high.x, each->x), std::max(box.high.y, each->y),
                std::max(box.high.z, each->z)};
  }
  return box;
}

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
    const std::uint32_t* begin_;  // the indexes of the ring's first corner, and of the next ring's
  };

  Rings(const Vertex* corners, const std::uint32_t* begins, std::size_t size)
      : corners_(corners), begins_(begins), size_(size) {}

  Iterator begin() const { return {corners_, begins_}; }
  Iterator end() const { return {corners_, begins_ + size_}; }
  std::size_t size() const { return size_; }
  Ring operator[](std::size_t ring) const { return *Iterator(corners_, begins_ + ring); }
  /// Returns the corners of all rings, which are consecutive.
  Ring corners() const { return {corners_ + begins_[0], corners_ + begins_[size_]}; }

 private:
  const Vertex* corners_;
  const std::uint32_t* begins_;
  std::size_t size_;
};

/// A region as rings in the plane of its incidence. The outer ring is first, counter-clockwise seen
/// from the tip of the normal; the holes follow, clockwise. Rings may touch in a vertex; they never
/// cross and never share a link. Owner: Polygons, until more are added.
struct Polygon {
  discmc::Incidence incidence;
  Rings rings;
};

/// Throws std::length_error if 32 bits cannot count the corners.
inline void require_numbers_for(std::size_t corners) {
  constexpr std::size_t max_corners = 0xFFFFFFFFu;
  if (corners > max_corners)
    throw std::length_error("the surface has more than " + std::to_string(max_corners) +
                            " corners, the limit of a mesh; extract a part, or shrink the volume");
}

/// A list of polygons. Limit: fewer than 2^32 corners, else std::length_error.
class Polygons {
 public:
  class Iterator {
   public:
    Iterator(const Polygons& polygons, std::size_t index) : polygons_(&polygons), index_(index) {}

    Polygon operator*() const { return (*polygons_)[index_]; }
    Iterator& operator++() {
      ++index_;
      return *this;
    }
    bool operator!=(const Iterator& other) const { return index_ != other.index_; }

   private:
    const Polygons* polygons_;
    std::size_t index_;
  };

  Polygons() { ring_begins_.push_back(0); }

  Iterator begin() const { return {*this, 0}; }
  Iterator end() const { return {*this, size()}; }
  std::size_t size() const { return records_.size(); }
  bool empty() const { return records_.empty(); }
  Polygon operator[](std::size_t index) const {
    const Record& record = records_[index];
    return {record.incidence,
            {corners_.data(), ring_begins_.data() + record.first_ring, record.rings}};
  }

  /// Returns the corners of all rings, in the order of adding polygons.
  const Array<Vertex>& corners() const { return corners_; }

  /// Adds a polygon without a ring.
  void add_polygon(Incidence incidence) {
    records_.push_back({static_cast<std::uint32_t>(ring_begins_.size() - 1), 0, incidence});
  }
  /// Adds a ring to the last added polygon. ring: not of this list.
  void add_ring(const Ring& ring) {
    require_numbers_for(corners_.size() + ring.size());
    corners_.append(ring.data(), ring.size());
    ring_begins_.push_back(static_cast<std::uint32_t>(corners_.size()));
    ++records_.back().rings;
  }
  /// Adds a polygon of another list.
  void push_back(const Polygon& polygon) {
    add_polygon(polygon.incidence);
    for (const Ring& ring : polygon.rings) add_ring(ring);
  }
  /// Adds all polygons of another list.
  void append(const Polygons& others) {
    require_numbers_for(corners_.size() + others.corners_.size());
    const auto first_ring = static_cast<std::uint32_t>(ring_begins_.size() - 1);
    const auto first_corner = static_cast<std::uint32_t>(corners_.size());
    for (Record record : others.records_) {
      record.first_ring += first_ring;
      records_.push_back(record);
    }
    for (std::size_t ring = 1; ring < others.ring_begins_.size(); ++ring)
      ring_begins_.push_back(first_corner + others.ring_begins_[ring]);
    corners_.append(others.corners_.data(), others.corners_.size());
  }

  /// Sorts polygons by the first corners of their outer rings (precedes()), then by their
  /// incidences and the other corners. jobs: threads that sort. Limit: each polygon has a ring.
  /// Cost: no corner is moved.
  void sort(unsigned jobs = 1);

 private:
  struct Record {
    std::uint32_t first_ring, rings;
    Incidence incidence;
  };
  struct Placed;

  const Vertex& first_corner(const Record& record) const {
    return corners_[ring_begins_[record.first_ring]];
  }
  bool is_before(const Record& a, const Record& b) const;
  void sort_layer(Record* begin, Record* end, bool is_flat);
  void sort(Placed* begin, Placed* end) const;
  void sort_rows(Array<Placed>& layer) const;

  Array<Record> records_;             // one per polygon
  Array<std::uint32_t> ring_begins_;  // indexes of corners_; one more than rings
  Array<Vertex> corners_;
};

}  // namespace discmc::meshing

#endif
