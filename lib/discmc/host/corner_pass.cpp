#include <discmc/host/corner_pass.hpp>

namespace discmc::trace {

namespace {

/// By the axis of an edge: the links that lead from a vertex on it to a centroid, a bit each. They
/// are diagonal, and lead away from the edge.
struct CentroidLinks {
  uint32_t of[3];
};
constexpr CentroidLinks links_to_centroids() {
  CentroidLinks to_centroids{};
  for (Link link = 0; link < link_codes; ++link) {
    const Vertex v = link_vector(link);
    const int32_t along[] = {v.x, v.y, v.z};
    for (int axis = 0; axis < 3; ++axis)
      if (along[axis] == 0 && dot(v, v) == 2) to_centroids.of[axis] |= 1U << link;
  }
  return to_centroids;
}
constexpr CentroidLinks centroid_links = links_to_centroids();

}  // namespace

uint32_t corner_passes(const Pass& pass, int axis, CornerPass* passes) {
  const Port in = pass.comes_from_ahead ? entry_of(pass.in) : exit_of(pass.in);
  const Port out = pass.goes_ahead() ? entry_of(pass.out) : exit_of(pass.out);
  const Vertex vertex{axis == 0 ? 1 : 0, axis == 1 ? 1 : 0, axis == 2 ? 1 : 0};
  const Vertex centroid = vertex + link_vector(pass.first);
  const auto corner = [&](Port from, Port to, Link incoming, Link onwards, const Vertex& at) {
    CornerPass made;
    made.corner = CornerCode::vector(at) +
                  CornerCode::sides(pass.incidence, incoming, onwards, is_entry(from & to));
    made.in = from;
    made.out = to;
    made.if_straight = 0;
    made.joins = is_entry(from | to) ? 0 : 1;
    return made;
  };
  // Whether a chain that comes from ahead by a centroid turns there is not known: so a begin that
  // waits for it has a corner here.
  const bool comes_round =
      pass.comes_from_ahead && (centroid_links.of[axis] >> pass.incoming & 1) != 0;
  const bool turns = pass.turns() || comes_round;
  const bool turns_at_centroid = pass.turns_at_centroid();
  if (!turns || !turns_at_centroid) {
    passes[0] = corner(in, out, pass.incoming, pass.second, turns_at_centroid ? centroid : vertex);
    if (!turns && !turns_at_centroid && is_entry(in ^ out)) passes[0].if_straight = -1;
    return 1;
  }
  // The corner at the centroid comes first where an end waits for the chain there, and that at the
  // vertex where the chain goes on from the centroid: so the second one is never an origin.
  const bool has_centroid_first = !pass.goes_ahead();
  const Port leave = has_centroid_first ? exit_of(inner_queue) : entry_of(inner_queue);
  const Port enter = has_centroid_first ? entry_of(inner_queue) : exit_of(inner_queue);
  passes[has_centroid_first ? 1 : 0] = corner(in, leave, pass.incoming, pass.first, vertex);
  passes[has_centroid_first ? 0 : 1] = corner(enter, out, pass.first, pass.second, centroid);
  return 2;
}

}  // namespace discmc::trace
