// Rings of version 1, and the fragments that stand elsewhere in the stream.
#ifndef DISCMC_COMMAND_STREAMS_VERSION1_FRAGMENTS_HPP
#define DISCMC_COMMAND_STREAMS_VERSION1_FRAGMENTS_HPP

#include <cstddef>
#include <cstdint>
#include <unordered_map>
#include <vector>

#include <discmc/chain.hpp>
#include <discmc/normal.hpp>

namespace discmc::host::version1 {

/// A run of a chain, or a stand-in: here comes the fragment of this number.
class Side {
 public:
  static constexpr std::uint32_t max_number = (std::uint32_t{1} << 31) - 1;

  explicit Side(Run run) : code_(run.code()) {}
  /// Limit: at most max_number.
  static Side stand_in(std::uint32_t number) { return Side(Run::from_code(stand_in_bit | number)); }

  bool is_stand_in() const { return (code_ & stand_in_bit) != 0; }
  std::uint32_t number() const { return code_ & max_number; }
  Run run() const { return Run::from_code(code_); }
  /// As Run::absorb(). Limit: runs.
  bool absorb(const Side& other) {
    Run both = run();
    const bool is_absorbed = both.absorb(other.run());
    code_ = both.code();
    return is_absorbed;
  }

  OctahedralNormal normal{0, 0};  ///< where it starts

 private:
  static constexpr std::uint32_t stand_in_bit = std::uint32_t{1} << 31;
  std::uint32_t code_;
};

using Chain = std::vector<Side>;

/// About the memory that a chain takes, with what it stands in.
constexpr std::size_t bytes_of(std::size_t sides) {
  constexpr std::size_t of_chain = 64;
  return of_chain + sides * sizeof(Side);
}

struct Ring {
  Vertex start;
  Chain chain;
};

/// Joins neighbouring runs of one direction, and lets the ring begin at the last of its vertices in
/// the order z, y, x: so version 2 tells rings, and the same ring makes the same triangles. Limit:
/// no stand-in, at least one run.
void arrange(Incidence incidence, Ring& ring);

/// The fragments that no ring has taken yet.
class Fragments {
 public:
  /// One of this number before is forgotten.
  void add(std::uint32_t number, Incidence incidence, Chain&& chain);
  /// Puts fragments, and those in them, where their stand-ins are. Each is used once. False when
  /// one is missing, or is of another incidence: its directions mean nothing in this ring.
  bool put_back(Incidence incidence, Chain& chain);
  /// About the memory that they take.
  std::size_t bytes() const { return bytes_; }

 private:
  struct Waiting {
    Incidence incidence;
    Chain chain;
  };

  bool take(std::uint32_t number, Incidence incidence, Chain& chain);

  std::unordered_map<std::uint32_t, Waiting> waiting_;
  std::size_t bytes_ = 0;
};

}  // namespace discmc::host::version1

#endif
