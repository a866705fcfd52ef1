// Where a slab ends: included where Extractor is instantiated, so that only programs that scan
// slabs link it.
#ifndef DISCMC_TRACE_SEAMS_HPP
#define DISCMC_TRACE_SEAMS_HPP

#include <discmc/trace/fragments.hpp>

namespace discmc::trace {

template <class Index, class Normal>
void Fragments<Index, Normal>::cut_at_seam(Fragments& fragments, const Pass& pass,
                                           const Vertex& vertex, bool ends) {
  if (ends)
    fragments.end_at_seam(pass, vertex);
  else
    fragments.begin_below_seam(pass, vertex);
}

// The cells above take no part, so that no chain goes up from here: those in rising queues are
// below.
template <class Index, class Normal>
void Fragments<Index, Normal>::end_at_seam(const Pass& pass, const Vertex& vertex) {
  if (pass.in < first_rising_queue) return;
  const Index tail = pop(pass.in);
  Vertex at = vertex;
  if (tail != no_record) end_tail(pass, tail, pass.came, at);
}

template <class Index, class Normal>
void Fragments<Index, Normal>::begin_below_seam(const Pass& pass, const Vertex& vertex) {
  if (pass.out < first_rising_queue) return;
  const Index begin = pop(pass.out);
  if (begin == no_record) return;
  const Vertex next = next_vertex(pass, vertex);
  if (end(begin).side.place() != place_of(next))
    turn_back(begin, pass.second, place_of(next), direction(pass, pass.second), {});
  lose_begin(pass, begin, pass.second, next);
}

}  // namespace discmc::trace

#endif
