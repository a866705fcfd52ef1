#include <discmc/join/region_holes.hpp>

namespace discmc::join {

using State = HeldChain::State;

void RegionHoles::follow(const Event& event, WaitingChains& waiting) {
  switch (event.kind) {
    case Event::Kind::region:
      incidence_ = event.incidence;
      first_ = no_chain;
      return;
    case Event::Kind::ring:
      return begin_ring(event, waiting);
    case Event::Kind::run:
      if (first_ != no_chain) add_run(event.run, waiting.chains());
      return;
    default:
      return;
  }
}

void RegionHoles::begin_ring(const Event& event, WaitingChains& waiting) {
  at_ = event.start;
  if (event.hole || waiting.hole_count() == 0) return;
  first_ = waiting.first_hole(incidence_, event.start);
  HeldChains& chains = waiting.chains();
  for (uint32_t hole = first_; hole != no_chain; hole = chains[hole].next)
    chains[hole].state = State::hole;
}

void RegionHoles::add_run(Run run, HeldChains& chains) {
  if (!is_run_of(incidence_, run)) return forget();
  point_ = point_beside(incidence_, at_, run.direction());
  const PlaneSide side(incidence_, at_, run);
  for (uint32_t hole = first_; hole != no_chain; hole = chains[hole].next) {
    State& state = chains[hole].state;
    if (side.meets_ray(chains.point_beside(hole)))
      state = state == State::hole ? State::hole_inside : State::hole;
  }
  at_ = after_run(incidence_, at_, run);
}

uint32_t RegionHoles::claim(WaitingChains& waiting) {
  const uint32_t first = first_;
  if (first == no_chain) return no_chain;
  HeldChains& chains = waiting.chains();
  for (uint32_t hole = first; hole != no_chain; hole = chains[hole].next)
    if (chains[hole].state == State::hole_inside && !is_within_another(hole, waiting))
      chains[hole].state = State::hole_claimed;
  forget();
  return waiting.take_claimed(first);
}

bool RegionHoles::is_within_another(uint32_t hole, const WaitingChains& waiting) const {
  const HeldChains& chains = waiting.chains();
  const PlanePoint point = chains.point_beside(hole);
  // The hole itself does not contain the point beside it.
  for (uint32_t other = first_; other != no_chain; other = chains[other].next)
    if (chains[other].state != State::hole && chains.contains(other, point)) return true;
  // An outer ring may also lie around the region.
  uint32_t outer = waiting.first_outer(incidence_, chains[hole].start);
  for (; outer != no_chain; outer = chains[outer].next)
    if (chains.contains(outer, point) && !chains.contains(outer, point_)) return true;
  return false;
}

}  // namespace discmc::join
