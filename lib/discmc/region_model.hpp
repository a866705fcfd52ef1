// What the stream's bits mean: how regions, fragments and marks are told in binary decisions.
//
// The same functions encode and decode: a Coder's bit(context, bit) writes the bit it is given and
// returns it, or ignores it and returns the bit it reads. So each function returns what was coded.
// Every context has a fixed probability (region_model.cpp), found by training; nothing is learnt on
// the way, so that every packet decodes alone.
#ifndef DISCMC_REGION_MODEL_HPP
#define DISCMC_REGION_MODEL_HPP

#include <discmc/range_coder.hpp>
#include <discmc/record.hpp>

namespace discmc {

/// The contexts, by what they tell.
namespace context {

constexpr uint16_t size_of_number = 8;  ///< contexts of the unary part of a number
constexpr uint16_t size_of_delta = 2 + size_of_number;

constexpr uint16_t region_follows = 0;                    ///< by: whether a mark came last
constexpr uint16_t other_kind = region_follows + 2;       ///< tree of 3 bits
constexpr uint16_t component_zero = other_kind + 8;       ///< of the normal; by axis, before, zeros
constexpr uint16_t component_sign = component_zero + 27;  ///< likewise
constexpr uint16_t one_ring = component_sign + 27;        ///< by class
constexpr uint16_t start_z = one_ring + 3;                ///< by: mark came last, class
constexpr uint16_t start_y = start_z + 6 * size_of_delta;      ///< by z step
constexpr uint16_t start_x = start_y + 6 * size_of_delta;      ///< by same layer, y step
constexpr uint16_t start_hole = start_x + 10 * size_of_delta;  ///< z, y, x of a further ring
constexpr uint16_t first_direction =
    start_hole + 3 * size_of_delta;                           ///< by incidence, tree of 3 bits
constexpr uint16_t parallelogram = first_direction + 27 * 8;  ///< by class
constexpr uint16_t run_count = parallelogram + 3;             ///< by class
constexpr uint16_t next_turn =
    run_count + 3 * size_of_number;                  ///< by class, turn before, tree of 3 bits
constexpr uint16_t run_length = next_turn + 27 * 8;  ///< by class, kind of link, length before
constexpr uint16_t item_kind = run_length + 24 * size_of_number;  ///< of a part: tree of 2 bits
constexpr uint16_t part_kind = item_kind + 4;                     ///< fragment, continues, is last
constexpr uint16_t fragment_number = part_kind + 3;               ///< of a fragment, of a stand-in
constexpr uint16_t count = fragment_number + 2 * size_of_delta;

constexpr uint16_t even = 0xFFFF;  ///< no context: one or zero, equally likely

}  // namespace context

/// The probability of a one in each context, in 256ths.
extern const Probability region_model[context::count];

/// What a record that is no region is.
enum class OtherKind : uint8_t { layer, end, part, skipped, extension };

/// What comes next in a part of a region or fragment.
enum class Item : uint8_t { run, fragment, ring, end };

// Differences wrap: any 32-bit coordinates come through.
constexpr int32_t wrapped_difference(uint32_t a, uint32_t b) {
  return static_cast<int32_t>(a - b);
}
constexpr int32_t wrapped_sum(int32_t a, int32_t b) {
  return static_cast<int32_t>(static_cast<uint32_t>(a) + static_cast<uint32_t>(b));
}

/// The state that goes from one record of a packet to the next, and the grammar of records.
/// A copy is a snapshot. Coder has: bool bit(uint16_t context, bool bit).
template <class Coder>
class RegionModel {
 public:
  RegionModel() = default;
  /// The state that every packet begins with.
  explicit RegionModel(const Coder& coder) : incidence_(no_incidence), coder_(coder) {}

  Coder& coder() { return coder_; }
  const Coder& coder() const { return coder_; }

  bool region_follows(bool follows) {
    return bit(context::region_follows + (after_region_ ? 0U : 1U), follows);
  }
  OtherKind other_kind(OtherKind kind) {
    return static_cast<OtherKind>(tree(context::other_kind, 3, static_cast<uint32_t>(kind)));
  }

  /// A layer mark's slice.
  uint32_t layer(uint32_t slice) {
    after_region_ = false;
    return slice_ += number(context::even, slice - slice_);
  }
  /// A number or some bits without a context.
  uint32_t plain_number(uint32_t value) { return number(context::even, value); }
  uint32_t plain_bits(int count, uint32_t value) { return tree(context::even, count, value); }

  /// The normal, guessed from that of the record before.
  Incidence incidence(Incidence incidence);
  uint32_t ring_count(uint32_t count);
  /// A ring's start, relative to that of the ring before; begins its chain. `further` for all but
  /// the first ring of a region. Limit: an odd coordinate sum.
  Vertex start(const Vertex& start, bool further);
  bool parallelogram(bool is_parallelogram) {
    return bit(context::parallelogram + link_class(), is_parallelogram);
  }
  /// How many runs a ring has. Limit: at least 2.
  uint32_t run_count(uint32_t count) {
    return 2 + number(context::run_count + link_class() * context::size_of_number, count - 2);
  }
  /// A run's direction. Decoding, any of 8 may come back: see is_direction().
  Direction direction(Direction direction);
  /// A run's length, after its direction. Limit: at least 1.
  uint32_t length(uint32_t length);

  /// A part of a region that is not compact, or of a fragment: part(), then item_kind() with
  /// direction() and length(), plain_number() or start() for each item, and end_part() last.
  void part(Record& record);
  Item item_kind(Item kind) {
    return static_cast<Item>(tree(context::item_kind, 2, static_cast<uint32_t>(kind)));
  }
  /// The number of a fragment, or of one that is put back here, relative to the last one told.
  uint32_t fragment_number(uint32_t number, bool is_put_back) {
    const uint32_t first = context::fragment_number + (is_put_back ? context::size_of_delta : 0U);
    return fragment_ += static_cast<uint32_t>(delta(first, wrapped_difference(number, fragment_)));
  }
  bool end_part(bool is_last) { return bit(context::part_kind + 2, is_last); }

 private:
  static constexpr uint32_t no_turn = 8;

  bool bit(uint32_t context, bool value) {
    return coder_.bit(static_cast<uint16_t>(context), value);
  }
  uint32_t tree(uint32_t first, int bits, uint32_t value);
  uint32_t number(uint32_t first, uint32_t value);
  int32_t delta(uint32_t first, int32_t value);
  void begin_chain(bool further) {
    turn_ = no_turn;
    length_ = 0;
    has_direction_ = false;
    further_ = further;
  }
  uint32_t link_class() const {
    const uint32_t count = direction_count(incidence_);
    return count == 8 ? 0 : count / 2 - 1;  // axis, diagonal, corner
  }

  Incidence incidence_ = 0;
  Direction direction_ = 0;
  bool has_direction_ = false;
  bool further_ = false;
  bool after_region_ = false;
  Coder coder_;
  Vertex start_{0, 0, 0};
  uint32_t slice_ = 0;
  uint32_t fragment_ = 0;
  uint32_t length_ = 0;
  uint32_t turn_ = 0;
};

/// Whether a decoded direction is one of the incidence's.
constexpr bool is_direction(Incidence incidence, Direction direction) {
  return direction < direction_count(incidence);
}

/// The lengths of the two last runs of a ring, which follow from the way that is left.
struct Closure {
  bool is_valid;
  uint32_t first, second;
};

/// Closes a ring along directions u and v by `way`. When they are parallel the length along u is
/// `told`. Invalid where no two lengths of 1 to max_compact_length do it.
Closure close_ring(const Vertex& u, const Vertex& v, const Vertex& way, uint32_t told);

constexpr bool are_parallel(Incidence incidence, Direction a, Direction b) {
  return a == b || a == opposite_direction(incidence, b);
}

/// Longer runs, and rings with fragments in them, are told in parts.
constexpr uint32_t max_compact_length = 0xFFFF;

// ---- implementation ----

template <class Coder>
uint32_t RegionModel<Coder>::tree(uint32_t first, int bits, uint32_t value) {
  uint32_t node = 1;
  for (int i = bits - 1; i >= 0; --i) {
    const uint32_t context = first == context::even ? first : first + node;
    node = 2 * node + (bit(context, value >> i & 1) ? 1 : 0);
  }
  return node - (uint32_t{1} << bits);
}

// Exponential Golomb code (J. Teuhola, 1978): the length of value + 1 in unary, then its lower
// bits.
template <class Coder>
uint32_t RegionModel<Coder>::number(uint32_t first, uint32_t value) {
  int bits = 0;
  for (;; ++bits) {
    const uint32_t step =
        bits < context::size_of_number ? static_cast<uint32_t>(bits) : context::size_of_number - 1;
    const bool is_longer = bits < 31 && (value + 1) >> bits > 1;
    if (!bit(first == context::even ? first : first + step, is_longer) || bits == 31) break;
  }
  return (uint32_t{1} << bits) - 1 + tree(context::even, bits, value + 1 - (uint32_t{1} << bits));
}

template <class Coder>
int32_t RegionModel<Coder>::delta(uint32_t first, int32_t value) {
  if (bit(first, value == 0)) return 0;
  const bool negative = bit(first + 1, value < 0);
  const uint32_t size = negative ? ~static_cast<uint32_t>(value) : static_cast<uint32_t>(value) - 1;
  const uint32_t coded = number(first + 2, size);
  return static_cast<int32_t>(negative ? ~coded : coded + 1);
}

// Component by component, z first, each guessed from the region before.
template <class Coder>
Incidence RegionModel<Coder>::incidence(Incidence incidence) {
  // The components plus one are the digits to base 3.
  constexpr uint8_t weights[3] = {9, 3, 1};
  const auto take_digit = [](uint32_t& number, uint32_t weight) {
    uint32_t digit = 0;
    for (; number >= weight; number -= weight) ++digit;
    return digit;
  };
  uint32_t told = incidence;
  uint32_t before = incidence_;
  uint32_t coded = 0;
  uint32_t zeros = 0;
  uint32_t at = 0;
  for (const uint8_t weight : weights) {
    const uint32_t digit = take_digit(told, weight);
    const uint32_t by = at + 3 * take_digit(before, weight) + zeros;
    uint32_t component = 1;
    if (zeros < 2 && bit(context::component_zero + by, digit == 1))
      ++zeros;
    else
      component = bit(context::component_sign + by, digit == 0) ? 0 : 2;
    coded = 3 * coded + component;
    at += 9;
  }
  incidence_ = static_cast<Incidence>(coded);
  return incidence_;
}

template <class Coder>
uint32_t RegionModel<Coder>::ring_count(uint32_t count) {
  if (bit(context::one_ring + link_class(), count == 1)) return 1;
  return 2 + number(context::even, count - 2);
}

template <class Coder>
Vertex RegionModel<Coder>::start(const Vertex& start, bool further) {
  using namespace context;
  const uint32_t by_class = link_class() + (after_region_ ? 0U : 3U);
  const int32_t dz =
      delta(further ? start_hole : start_z + by_class * size_of_delta,
            wrapped_difference(static_cast<uint32_t>(start.z), static_cast<uint32_t>(start_.z)));
  const uint32_t by_z = dz < -2 || dz > 2 ? 5U : static_cast<uint32_t>(dz + 2);
  const int32_t dy =
      delta(further ? start_hole + size_of_delta : start_y + by_z * size_of_delta,
            wrapped_difference(static_cast<uint32_t>(start.y), static_cast<uint32_t>(start_.y)));
  const uint32_t by_y = dy < -2 ? 0U : dy > 2 ? 4U : static_cast<uint32_t>(dy + 2);
  const uint32_t by_zy = (dz < -1 || dz > 1 ? 0U : 5U) + by_y;
  // The sum of the coordinates is odd, so of x only the half is told.
  const int32_t half =
      delta(further ? start_hole + 2 * size_of_delta : start_x + by_zy * size_of_delta,
            wrapped_difference(static_cast<uint32_t>(start.x >> 1),
                               static_cast<uint32_t>(start_.x >> 1)));
  start_.z = wrapped_sum(start_.z, dz);
  start_.y = wrapped_sum(start_.y, dy);
  const uint32_t x = static_cast<uint32_t>(wrapped_sum(start_.x >> 1, half)) << 1;
  const uint32_t parity = static_cast<uint32_t>(start_.y ^ start_.z ^ 1) & 1;
  start_.x = static_cast<int32_t>(x | parity);
  after_region_ = true;
  begin_chain(further);
  return start_;
}

// The first direction of a region depends on its incidence: rings start where the sweep closed
// them.
template <class Coder>
Direction RegionModel<Coder>::direction(Direction direction) {
  const uint32_t count = direction_count(incidence_);
  if (!has_direction_) {
    const uint32_t first =
        further_ ? uint32_t{context::even} : context::first_direction + uint32_t{incidence_} * 8;
    direction_ = static_cast<Direction>(tree(first, 3, direction));
    has_direction_ = true;
    return direction_;
  }
  const uint32_t first = context::next_turn + (9 * link_class() + turn_) * 8;
  const uint32_t back = direction < direction_ ? count : 0;
  turn_ = tree(first, 3, direction + back - direction_);
  const uint32_t sum = direction_ + turn_;
  direction_ = static_cast<Direction>(sum < count ? sum : sum - count);
  return direction_;
}

template <class Coder>
uint32_t RegionModel<Coder>::length(uint32_t length) {
  const bool is_axis_link = direction_count(incidence_) == 8 && direction_ % 2 == 0;
  const uint32_t before = length_ < 3 ? length_ : 3;
  const uint32_t by = 8 * link_class() + (is_axis_link ? 4U : 0U) + before;
  length_ = 1 + number(context::run_length + by * context::size_of_number, length - 1);
  return length_;
}

template <class Coder>
void RegionModel<Coder>::part(Record& record) {
  record.is_fragment = bit(context::part_kind, record.is_fragment);
  record.continues = bit(context::part_kind + 1, record.continues);
  if (record.is_fragment) record.number = fragment_number(record.number, false);
  record.incidence = incidence(record.incidence);
  begin_chain(true);
}

}  // namespace discmc

#endif
