#include "fragments.hpp"

#include <algorithm>
#include <utility>

#include <discmc/plane.hpp>

namespace discmc::host::version1 {
namespace {

// The normal where a side that is taken in starts is that of no corner.
void join_sides(Chain& chain) {
  std::size_t last = 0;
  for (std::size_t i = 1; i < chain.size(); ++i)
    if (!chain[last].absorb(chain[i])) chain[++last] = chain[i];
  chain.resize(last + 1, chain.front());
}

}  // namespace

void arrange(Incidence incidence, Ring& ring) {
  join_sides(ring.chain);
  Vertex vertex = ring.start, last = ring.start;
  auto first = ring.chain.begin();
  for (auto side = ring.chain.begin(); side != ring.chain.end(); ++side) {
    if (precedes(last, vertex)) {
      last = vertex;
      first = side;
    }
    vertex = after_run(incidence, vertex, side->run());
  }
  if (vertex != ring.start) return;  // it is not closed
  std::rotate(ring.chain.begin(), first, ring.chain.end());
  ring.start = last;
  // It may have begun within a side.
  join_sides(ring.chain);
}

void Fragments::add(std::uint32_t number, Incidence incidence, Chain&& chain) {
  const auto [place, is_new] = waiting_.try_emplace(number);
  if (!is_new) bytes_ -= bytes_of(place->second.chain.size());
  bytes_ += bytes_of(chain.size());
  place->second = {incidence, std::move(chain)};
}

bool Fragments::take(std::uint32_t number, Incidence incidence, Chain& chain) {
  const auto found = waiting_.find(number);
  if (found == waiting_.end() || found->second.incidence != incidence) return false;
  chain = std::move(found->second.chain);
  bytes_ -= bytes_of(chain.size());
  waiting_.erase(found);
  return true;
}

bool Fragments::put_back(Incidence incidence, Chain& chain) {
  const auto is_stand_in = [](const Side& side) { return side.is_stand_in(); };
  if (std::none_of(chain.begin(), chain.end(), is_stand_in)) return true;
  Chain whole, fragment;
  Chain left(chain.rbegin(), chain.rend());  // what comes next is the last
  bool is_whole = true;
  while (!left.empty()) {
    const Side side = left.back();
    left.pop_back();
    if (!side.is_stand_in()) {
      whole.push_back(side);
      continue;
    }
    fragment.clear();
    // Others are looked up all the same: they are of no use to another ring.
    is_whole = take(side.number(), incidence, fragment) && is_whole;
    left.insert(left.end(), fragment.rbegin(), fragment.rend());
    // The normal where a fragment starts is told with its stand-in.
    if (!fragment.empty() && !side.normal.is_none()) left.back().normal = side.normal;
  }
  chain = std::move(whole);
  return is_whole;
}

}  // namespace discmc::host::version1
