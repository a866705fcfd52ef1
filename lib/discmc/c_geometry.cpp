// discmc.h in terms of the C++ library: the lattice, chains, polygons and facets. A file of its
// own, so that firmware which only scans does not carry it.
//
// Runs and vertices have the same layout on both sides; arrays of them are looked at in place.
#include <discmc/discmc.h>

#include <discmc/c_values.hpp>
#include <discmc/facet_table.hpp>
#include <discmc/plane.hpp>
#include <discmc/polygon.hpp>

namespace discmc {

namespace {

static_assert(sizeof(Run) == sizeof(discmc_run) && Run::max_length == DISCMC_RUN_MAX_LENGTH,
              "a run is its code");
static_assert(sizeof(Vertex) == sizeof(discmc_vertex) &&
                  offsetof(Vertex, x) == offsetof(discmc_vertex, x) &&
                  offsetof(Vertex, y) == offsetof(discmc_vertex, y) &&
                  offsetof(Vertex, z) == offsetof(discmc_vertex, z),
              "vertices have one layout");
static_assert(no_incidence == DISCMC_NO_INCIDENCE && incidence_codes == DISCMC_INCIDENCE_CODES &&
                  link_codes == DISCMC_LINK_CODES && max_directions == DISCMC_MAX_DIRECTIONS &&
                  no_direction == DISCMC_NO_DIRECTION,
              "constants are the same");

discmc_vertex c(const Vertex& from) {
  return {from.x, from.y, from.z};
}
discmc_plane_point c(const PlanePoint& from) {
  return {from.u, from.v};
}
const Run* cpp(const discmc_run* runs) {
  return reinterpret_cast<const Run*>(runs);
}
Run* cpp(discmc_run* runs) {
  return reinterpret_cast<Run*>(runs);
}
Vertex* cpp(discmc_vertex* vertices) {
  return reinterpret_cast<Vertex*>(vertices);
}
const Vertex* cpp(const discmc_vertex* vertices) {
  return reinterpret_cast<const Vertex*>(vertices);
}

}  // namespace

extern "C" {

discmc_vertex discmc_normal(uint8_t incidence) {
  return c(normal(incidence));
}
uint8_t discmc_incidence_of(discmc_vertex normal) {
  return incidence_of(cpp(normal));
}
uint8_t discmc_opposite(uint8_t incidence) {
  return opposite(incidence);
}
discmc_vertex discmc_link_vector(uint8_t link) {
  return c(link_vector(link));
}
uint8_t discmc_opposite_link(uint8_t link) {
  return opposite_link(link);
}
uint8_t discmc_direction_count(uint8_t incidence) {
  return direction_count(incidence);
}
discmc_vertex discmc_direction_vector(uint8_t incidence, uint8_t direction) {
  return c(direction_vector(incidence, direction));
}
uint8_t discmc_link_of(uint8_t incidence, uint8_t direction) {
  return link_of(incidence, direction);
}
uint8_t discmc_opposite_direction(uint8_t incidence, uint8_t direction) {
  return opposite_direction(incidence, direction);
}
uint8_t discmc_direction_of(uint8_t incidence, uint8_t link) {
  return direction_of(incidence, link);
}
uint8_t discmc_direction_of_vector(uint8_t incidence, discmc_vertex vector) {
  return direction_of(incidence, cpp(vector));
}
int discmc_turn(uint8_t incidence, uint8_t from, uint8_t to) {
  return turn(incidence, from, to);
}

discmc_run discmc_run_straight(uint8_t direction, uint32_t length) {
  return Run::straight(direction, length).code();
}
uint8_t discmc_run_direction(discmc_run run) {
  return Run::from_code(run).direction();
}
uint32_t discmc_run_length(discmc_run run) {
  return Run::from_code(run).length();
}
uint8_t discmc_run_absorb(discmc_run* run, discmc_run other) {
  return cpp(run)->absorb(Run::from_code(other)) ? 1 : 0;
}

discmc_vertex discmc_displacement(uint8_t incidence, const discmc_run* runs, uint32_t count) {
  return c(displacement(incidence, cpp(runs), count));
}
uint8_t discmc_is_closed(uint8_t incidence, const discmc_run* runs, uint32_t count) {
  return is_closed(incidence, cpp(runs), count) ? 1 : 0;
}
void discmc_reverse(uint8_t incidence, discmc_run* runs, uint32_t count) {
  reverse(incidence, cpp(runs), count);
}
int64_t discmc_twice_area(uint8_t incidence, const discmc_run* runs, uint32_t count) {
  return twice_area(incidence, cpp(runs), count);
}
uint64_t discmc_link_count(const discmc_run* runs, uint32_t count) {
  return link_count(cpp(runs), count);
}

uint8_t discmc_is_incidence(uint8_t incidence) {
  return is_incidence(incidence) ? 1 : 0;
}
uint8_t discmc_is_direction_of(uint8_t incidence, uint8_t direction) {
  return is_direction_of(incidence, direction) ? 1 : 0;
}
uint8_t discmc_is_run_of(uint8_t incidence, discmc_run run) {
  return is_run_of(incidence, Run::from_code(run)) ? 1 : 0;
}
discmc_vertex discmc_after_run(uint8_t incidence, discmc_vertex from, discmc_run run) {
  return c(after_run(incidence, cpp(from), Run::from_code(run)));
}
int32_t discmc_plane_offset(uint8_t incidence, discmc_vertex vertex) {
  return plane_offset(incidence, cpp(vertex));
}
discmc_plane_point discmc_projected(uint8_t incidence, discmc_vertex vertex) {
  return c(projected(incidence, cpp(vertex)));
}
discmc_plane_point discmc_point_beside(uint8_t incidence, discmc_vertex start, uint8_t first) {
  return c(point_beside(incidence, cpp(start), first));
}
uint8_t discmc_meets_ray(uint8_t incidence, discmc_vertex from, discmc_run run,
                         discmc_plane_point point) {
  const PlaneSide side(incidence, cpp(from), Run::from_code(run));
  return side.meets_ray({point.u, point.v}) ? 1 : 0;
}

void discmc_unfold(uint8_t incidence, discmc_vertex start, const discmc_run* runs, uint32_t count,
                   discmc_vertex* vertices) {
  unfold(incidence, cpp(start), cpp(runs), count, cpp(vertices));
}
int64_t discmc_twice_area_of_ring(uint8_t incidence, const discmc_vertex* vertices,
                                  uint32_t count) {
  return twice_area(incidence, cpp(vertices), count);
}
void discmc_split_ring(discmc_vertex* vertices, uint32_t count, uint32_t* scratch,
                       const discmc_ring_receiver* receiver) {
  discmc_ring_receiver to = *receiver;
  const auto take = [](void* context, const Vertex* ring, uint32_t length) {
    const discmc_ring_receiver& rings = *static_cast<const discmc_ring_receiver*>(context);
    rings.take(rings.context, reinterpret_cast<const discmc_vertex*>(ring), length);
  };
  split_ring(cpp(vertices), count, scratch, {&to, take});
}
uint8_t discmc_is_corner(const discmc_vertex* vertices, uint32_t count, uint32_t i) {
  return is_corner(cpp(vertices), count, i) ? 1 : 0;
}
uint32_t discmc_keep_corners(discmc_vertex* vertices, uint32_t count,
                             uint8_t (*keep)(void* context, const discmc_vertex* vertex),
                             void* context) {
  return keep_corners(cpp(vertices), count, [=](const Vertex& vertex) {
    return keep != nullptr && keep(context, reinterpret_cast<const discmc_vertex*>(&vertex)) != 0;
  });
}

discmc_cell_facts discmc_facts_of(uint8_t configuration) {
  return {cell_facts.facets[configuration], cell_facts.classic_triangles[configuration],
          cell_facts.enclosed[configuration]};
}
uint8_t discmc_facet_at(uint8_t configuration, uint32_t i) {
  return facet_table.facet[facet_table.first[configuration] + i];
}
uint8_t discmc_incidence_of_facet(uint8_t facet) {
  return incidence_of(Facet{facet});
}
discmc_facet_ring discmc_ring_of_facet(uint8_t facet) {
  const FacetRing& ring = facet_rings.ring[facet];
  discmc_facet_ring result{};
  for (; result.count < ring.count; ++result.count)
    result.vertices[result.count] = c(position(ring.point[result.count]));
  return result;
}

discmc_neighbour discmc_across_edge(uint8_t facet, uint32_t edge) {
  const Neighbour neighbour = across_edge(facet, static_cast<int>(edge));
  return {c(neighbour.cell), neighbour.facet};
}

}  // extern "C"

}  // namespace discmc
