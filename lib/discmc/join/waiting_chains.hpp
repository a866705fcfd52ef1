// The waiting chains of a joiner: open chains wait for the fragments before and after them, rings
// for the other rings of their region.
#ifndef DISCMC_JOIN_WAITING_CHAINS_HPP
#define DISCMC_JOIN_WAITING_CHAINS_HPP

#include <discmc/base/arena.hpp>
#include <discmc/join/waiting_rings.hpp>
#include <discmc/join/waiting_table.hpp>

namespace discmc::detail::join {

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

  /// Lets a ring wait on its plane.
  void keep(uint32_t ring) { rings_.insert(chains_, ring); }
  WaitingRings& rings() { return rings_; }

  /// Empties table and trees, after all chains were passed on one by one.
  void forget();

 private:
  // The role of a chain in the table: an entry is an index and a role.
  enum class Role : uint8_t { start, end };

  // Per chain: both of its ends wait.
  static constexpr uint32_t buckets_for(uint32_t chains) {
    return WaitingTable::buckets_for(2 * chains);
  }
  static constexpr uint32_t entry(uint32_t chain, Role role) {
    return chain << 1 | static_cast<uint32_t>(role);
  }
  static constexpr uint32_t chain_of(uint32_t entry) { return entry >> 1; }
  static constexpr Role role_of(uint32_t entry) { return static_cast<Role>(entry & 1); }
  WaitingKey key_of(uint32_t entry) const;
  uint32_t find(const WaitingKey& key) const;

  HeldChains chains_;
  WaitingTable table_;
  WaitingRings rings_;
};

}  // namespace discmc::detail::join

#endif
