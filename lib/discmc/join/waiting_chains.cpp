#include <discmc/join/waiting_chains.hpp>

namespace discmc::detail::join {

namespace {

constexpr uint32_t none = WaitingTable::none;

}  // namespace

void WaitingChains::start(Arena& arena, uint32_t chains, uint32_t runs) {
  HeldChain* const chain_slots = arena.allocate<HeldChain>(chains);
  chains_.start(chain_slots, chains, arena.allocate<HeldRun>(runs), runs);
  chains_.clear();
  const uint32_t buckets = buckets_for(chains);
  uint32_t* const hashes = arena.allocate<uint32_t>(buckets);
  table_.start(hashes, arena.allocate<uint32_t>(buckets), buckets);
  DISCMC_LIMIT(!arena.is_exhausted());
  forget();
}

WaitingKey WaitingChains::key_of(uint32_t entry) const {
  const uint32_t chain = chain_of(entry);
  return role_of(entry) == Role::start ? chains_.start_key(chain) : chains_.end_key(chain);
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

void WaitingChains::forget() {
  table_.clear();
  rings_.clear();
}

}  // namespace discmc::detail::join
