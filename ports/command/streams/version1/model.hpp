// What the bits of a packet of records of version 1 mean. See WIRE.md, section 15.
//
// Every context has a fixed probability, as in version 2, but there are others of them, and loose
// fragments have numbers instead of places.
#ifndef DISCMC_COMMAND_STREAMS_VERSION1_MODEL_HPP
#define DISCMC_COMMAND_STREAMS_VERSION1_MODEL_HPP

#include <cstddef>
#include <cstdint>

#include <discmc/lattice.hpp>
#include <discmc/stream/range_coder.hpp>

namespace discmc::host::version1 {

/// What a record that is no region is. Other numbers are reserved.
enum class OtherKind : std::uint8_t { layer, end, part, skipped, extension };

/// What comes next in a part of a region or fragment.
enum class Item : std::uint8_t { run, stand_in, ring, end };

/// What a part is of, and whether others come before it.
struct PartHead {
  bool is_fragment;
  bool continues;
  std::uint32_t number;  ///< of a fragment
  Incidence incidence;
};

/// Reads symbols, and keeps what goes on from one record of a packet to the next. Any bytes are
/// safe.
class Model {
 public:
  Model() = default;
  /// The state that every packet begins with. Owner: the bytes are the caller's, as long as symbols
  /// are read.
  Model(const std::uint8_t* bytes, std::size_t count) : range_(bytes, count) {}

  /// Whether more was read than the bytes can have held.
  bool is_exhausted() const { return range_.is_exhausted(); }

  bool region_follows();
  OtherKind other_kind();
  /// A layer mark's slice.
  std::uint32_t layer();
  std::uint32_t plain_number();
  /// As ToldNormals asks for them.
  std::uint32_t plain_bits(std::uint32_t count, std::uint32_t = 0);

  Incidence incidence();
  std::uint32_t ring_count();
  /// A ring's start; begins its chain. `further` for all but the first ring of a region.
  Vertex start(bool further);
  bool is_parallelogram();
  std::uint32_t run_count();
  /// A run's direction: any of 8, whether the incidence has it or not.
  Direction direction();
  /// Whether the last direction is that of the run before, or opposite to it.
  bool is_parallel() const;
  /// A run's length, after its direction: at least 1.
  std::uint32_t length();

  PartHead part();
  Item item();
  std::uint32_t stand_in();
  bool is_last_part();

 private:
  bool bit(std::uint32_t context);
  std::uint32_t tree(std::uint32_t first, std::uint32_t bits);
  std::uint32_t number(std::uint32_t first, std::uint32_t contexts);
  std::int32_t delta(std::uint32_t first);
  std::uint32_t fragment_number(std::uint32_t first);
  void begin_chain(bool further);
  std::uint32_t directions() const { return 4 + 2 * link_class_; }

  RangeDecoder range_;
  Incidence incidence_ = no_incidence;  // of the record before
  std::uint32_t link_class_ = 0;        // of its planes: diagonal, corner, axis
  bool is_after_region_ = false;
  Vertex start_{0, 0, 0};
  std::uint32_t slice_ = 0;
  std::uint32_t fragment_ = 0;
  // Of the chain:
  bool is_further_ = false;
  Direction direction_ = no_direction;
  std::uint32_t turns_ = 0;   // the last turn and one more; 0 before the first
  std::uint32_t length_ = 0;  // of the last run, at most 3; 0 before the first
};

}  // namespace discmc::host::version1

#endif
