// The waiting chains of a joiner: open chains wait for the fragments before and after them, rings
// for the other rings of their region.
#ifndef DISCMC_JOIN_WAITING_CHAINS_HPP
#define DISCMC_JOIN_WAITING_CHAINS_HPP

#include <discmc/arena.hpp>
#include <discmc/join/held_chains.hpp>
#include <discmc/join/waiting_table.hpp>

namespace discmc::join {

class WaitingChains {
 public:
  /// The result of joining a chain.
  enum class Joined : uint8_t {
    open,     ///< the chain waits
    ring,     ///< the chain is closed, and does not wait yet
    refused,  ///< another chain waits at its start, or at its end
    no_room,  ///< nothing can be joined from now on
  };
  struct Result {
    Joined joined;
    uint32_t chain;  ///< the chain that contains the fragment now
  };

  static constexpr uint64_t bytes_for(uint32_t chains, uint32_t runs) {
    return Arena::bytes_of(chains, sizeof(HeldChain)) + Arena::bytes_of(runs, sizeof(HeldRun)) +
           2 * Arena::bytes_of(buckets_for(chains), sizeof(uint32_t));
  }

  /// Allocates its arrays in the arena. Limit: they fit.
  void start(Arena& arena, uint32_t chains, uint32_t runs);

  HeldChains& chains() { return chains_; }
  const HeldChains& chains() const { return chains_; }

  /// Joins a chain that has runs with the chain before it and the chain after it. If refused, or
  /// without room, the chain is unchanged. Cost: a few look-ups.
  Result join(uint32_t arrived);

  /// Lets a ring wait on its plane. False if there is no room, which remains so.
  bool keep(uint32_t ring);

  /// The first of the holes, or of the outer rings, that wait on the plane of a vertex; the others
  /// follow by HeldChain::next.
  uint32_t first_hole(Incidence incidence, const Vertex& vertex) const;
  uint32_t first_outer(Incidence incidence, const Vertex& vertex) const;
  uint32_t hole_count() const { return hole_count_; }

  /// Takes the claimed holes out of a list of waiting holes. Returns the list of the claimed ones.
  uint32_t take_claimed(uint32_t first_hole);

  /// Takes out the first waiting outer ring on the plane of the given one.
  uint32_t take_outer(uint32_t outer);

  /// Empties the table, before all chains are passed on one by one.
  void forget();

 private:
  // The role of a chain in the table: an entry is an index and a role.
  enum class Role : uint8_t { start, end, hole, outer };

  // Per chain: both of its ends wait, or a ring.
  static constexpr uint32_t buckets_for(uint32_t chains) {
    return WaitingTable::buckets_for(2 * chains);
  }
  static constexpr uint32_t entry(uint32_t chain, Role role) {
    return chain << 2 | static_cast<uint32_t>(role);
  }
  static constexpr uint32_t chain_of(uint32_t entry) { return entry >> 2; }
  static constexpr Role role_of(uint32_t entry) { return static_cast<Role>(entry & 3); }
  static constexpr WaitingKey plane_key(Incidence incidence, const Vertex& vertex, Role role) {
    const int kind = max_directions + static_cast<int>(role);
    return {{plane_offset(incidence, vertex), 0, 0}, incidence, static_cast<uint8_t>(kind)};
  }
  WaitingKey plane_key(uint32_t ring, Role role) const {
    return plane_key(chains_[ring].incidence, chains_[ring].start, role);
  }
  WaitingKey key_of(uint32_t entry) const;
  uint32_t find(const WaitingKey& key) const;
  void set_first(uint32_t ring, uint32_t first, Role role);

  HeldChains chains_;
  WaitingTable table_;
  uint32_t hole_count_ = 0;
};

}  // namespace discmc::join

#endif
