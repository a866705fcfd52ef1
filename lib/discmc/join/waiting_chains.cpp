#include <discmc/join/waiting_chains.hpp>

namespace discmc::join {

namespace {

constexpr uint32_t none = WaitingTable::none;

}  // namespace

void WaitingChains::start(Arena& arena, uint32_t chains, uint32_t runs) {
  HeldChain* const chain_slots = arena.take<HeldChain>(chains);
  chains_.start(chain_slots, chains, arena.take<HeldRun>(runs), runs);
  chains_.clear();
  const uint32_t buckets = buckets_for(chains);
  uint32_t* const hashes = arena.take<uint32_t>(buckets);
  table_.start(hashes, arena.take<uint32_t>(buckets), buckets);
  forget();
}

WaitingKey WaitingChains::key_of(uint32_t entry) const {
  const uint32_t chain = chain_of(entry);
  switch (role_of(entry)) {
    case Role::start:
      return chains_.start_key(chain);
    case Role::end:
      return chains_.end_key(chain);
    default:
      return plane_key(chain, role_of(entry));
  }
}

uint32_t WaitingChains::find(const WaitingKey& key) const {
  return table_.find(
      key, [this](uint32_t entry, const WaitingKey& wanted) { return key_of(entry) == wanted; });
}

WaitingChains::Result WaitingChains::join(uint32_t arrived) {
  const WaitingKey start = chains_.start_key(arrived), end = chains_.end_key(arrived);
  if (start == end) return {Joined::ring, arrived};
  const uint32_t before = find(start), behind = find(end);
  if ((before != none && role_of(before) == Role::start) ||
      (behind != none && role_of(behind) == Role::end))
    return {Joined::refused, arrived};
  const uint32_t chain = before != none ? chain_of(before) : arrived;

  if (before == none && !table_.insert(start, entry(arrived, Role::start)))
    return {Joined::no_room, arrived};
  if (behind == none && !table_.insert(end, entry(chain, Role::end)))
    return {Joined::no_room, arrived};
  if (before != none) {
    table_.remove(start, before);
    chains_.join(chain, arrived);
  }
  if (behind == none) return {Joined::open, chain};
  table_.remove(end, behind);
  const uint32_t other = chain_of(behind);
  if (other == chain) return {Joined::ring, chain};
  table_.replace(chains_.end_key(other), entry(other, Role::end), entry(chain, Role::end));
  chains_.join(chain, other);
  return {Joined::open, chain};
}

bool WaitingChains::keep(uint32_t ring) {
  const bool is_hole = chains_[ring].is_hole();
  const Role role = is_hole ? Role::hole : Role::outer;
  const WaitingKey key = plane_key(ring, role);
  const uint32_t first = find(key);
  if (first != none)
    table_.replace(key, first, entry(ring, role));
  else if (!table_.insert(key, entry(ring, role)))
    return false;
  chains_[ring].next = chain_of(first);
  if (is_hole) ++hole_count_;
  return true;
}

uint32_t WaitingChains::first_hole(Incidence incidence, const Vertex& vertex) const {
  return chain_of(find(plane_key(incidence, vertex, Role::hole)));
}

uint32_t WaitingChains::first_outer(Incidence incidence, const Vertex& vertex) const {
  return chain_of(find(plane_key(incidence, vertex, Role::outer)));
}

// Replaces the first ring of a plane by another one, or by none.
void WaitingChains::set_first(uint32_t ring, uint32_t first, Role role) {
  table_.replace(plane_key(ring, role), entry(ring, role),
                 first != no_chain ? entry(first, role) : none);
}

uint32_t WaitingChains::take_claimed(uint32_t first_hole) {
  uint32_t claimed = no_chain, left = no_chain;
  for (uint32_t hole = first_hole; hole != no_chain;) {
    HeldChain& slot = chains_[hole];
    const bool is_claimed = slot.state == HeldChain::State::hole_claimed;
    uint32_t& list = is_claimed ? claimed : left;
    const uint32_t next = slot.next;
    slot.next = list;
    list = hole;
    if (is_claimed) --hole_count_;
    hole = next;
  }
  set_first(first_hole, left, Role::hole);
  return claimed;
}

uint32_t WaitingChains::take_outer(uint32_t outer) {
  const uint32_t first = first_outer(chains_[outer].incidence, chains_[outer].start);
  set_first(first, chains_[first].next, Role::outer);
  return first;
}

void WaitingChains::forget() {
  table_.clear();
  hole_count_ = 0;
}

}  // namespace discmc::join
