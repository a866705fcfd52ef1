// What the stream's bits mean: how regions, loose fragments and marks are told in binary decisions.
//
// The same functions encode and decode: a Coder's code_bit(context, bit) writes the bit it is given
// and returns it, or ignores it and returns the bit it reads. So each function returns what was
// coded. Every context has a fixed probability (region_model.cpp), found by training; nothing is
// learnt on the way, so that every packet decodes alone.
#ifndef DISCMC_STREAM_REGION_MODEL_HPP
#define DISCMC_STREAM_REGION_MODEL_HPP

#include <discmc/stream/range_coder.hpp>
#include <discmc/stream/record.hpp>

namespace discmc {

/// The contexts, by what they tell.
namespace context {

constexpr uint32_t size_of_delta = 2 + 8;   ///< zero, sign, and a number
constexpr uint32_t size_of_run_count = 8;   ///< of a number
constexpr uint32_t size_of_run_length = 7;  ///< likewise
constexpr uint32_t size_of_tree = 7;        ///< of 3 bits
constexpr uint32_t slopes = 5;

constexpr uint32_t even = 0;                                    ///< one or zero, equally likely
constexpr uint32_t region_follows = even + 1;                   ///< by: what came before
constexpr uint32_t fragment_follows = region_follows + 5;       ///< likewise
constexpr uint32_t other_kind = fragment_follows + 5;           ///< tree of 3 bits
constexpr uint32_t component_zero = other_kind + size_of_tree;  ///< of the normal; by zeros, before
constexpr uint32_t component_sign = component_zero + 15;        ///< likewise
constexpr uint32_t one_ring = component_sign + 18;              ///< by class
constexpr uint32_t start_z = one_ring + 3;                      ///< by: mark came last, class
constexpr uint32_t start_y = start_z + 6 * size_of_delta;       ///< by z step
constexpr uint32_t start_x = start_y + 6 * size_of_delta;       ///< by same layer, y step
constexpr uint32_t start_hole = start_x + 10 * size_of_delta;   ///< z, y, x of a further ring
constexpr uint32_t fragment_z = start_hole + 3 * size_of_delta;              ///< by: mark came last
constexpr uint32_t fragment_y = fragment_z + 2 * size_of_delta;              ///< by same z
constexpr uint32_t fragment_x = fragment_y + 2 * size_of_delta;              ///< by same y
constexpr uint32_t first_direction = fragment_x + 2 * size_of_delta;         ///< by slope, tree
constexpr uint32_t parallelogram = first_direction + slopes * size_of_tree;  ///< by class
constexpr uint32_t run_count = parallelogram + 3;                            ///< by class
constexpr uint32_t next_turn = run_count + 3 * size_of_run_count;  ///< by class, turn before, tree
constexpr uint32_t run_length = next_turn + 21 * size_of_tree;  ///< by kind of link, length before
constexpr uint32_t is_backwards = run_length + 16 * size_of_run_length;  ///< a fragment
constexpr uint32_t fragment_direction = is_backwards + 1;                ///< by slope, tree
constexpr uint32_t z_is_odd =
    fragment_direction + slopes * size_of_tree;            ///< by slope, rise, order
constexpr uint32_t y_is_odd = z_is_odd + 6 * slopes;       ///< by slope, z
constexpr uint32_t fragment_turn = y_is_odd + 2 * slopes;  ///< by slope, level, tree
constexpr uint32_t is_last_link =
    fragment_turn + 2 * slopes * size_of_tree;                       ///< by slope, level; many
constexpr uint32_t fragment_length = is_last_link + 2 * slopes + 1;  ///< by kind of link, level
constexpr uint32_t item_kind = fragment_length + 8 * size_of_run_length;  ///< of a part
constexpr uint32_t part_kind = item_kind + 2;  ///< fragment, continues, is last
constexpr uint32_t count = part_kind + 3;

}  // namespace context

/// The probability of a one in each context, in 256ths.
extern const Probability region_model[context::count];

/// What a record is. Any kind may come back from decoding, also beyond these.
enum class RecordKind : uint8_t { region, fragment, layer, end, part, skipped, extension };

/// What comes next in a part of a region or fragment.
enum class Item : uint8_t { run, ring, end };

/// What a chain is: the first ring of a region, any other chain that is told run by run, a whole
/// fragment, or one that is told from its end.
enum class ChainKind : uint8_t { first, further, fragment, backwards };

constexpr bool is_fragment(ChainKind kind) {
  return kind >= ChainKind::fragment;
}

// Differences wrap: any 32-bit coordinates come through.
constexpr int32_t wrapped_difference(uint32_t a, uint32_t b) {
  return static_cast<int32_t>(a - b);
}
constexpr int32_t wrapped_sum(int32_t a, int32_t b) {
  return static_cast<int32_t>(static_cast<uint32_t>(a) + static_cast<uint32_t>(b));
}
/// 1 when it is odd.
constexpr uint32_t parity_of(int32_t coordinate) {
  return static_cast<uint32_t>(coordinate) & 1;
}

/// Whether a link leads to another slice, and to which.
enum class Rise : uint8_t { level, up, down };

// Links are numbered in the order of z: 5 lead down, 8 are level, 5 lead up.
constexpr Rise rise_of(Link link) {
  return link < 5 ? Rise::down : link < 13 ? Rise::level : Rise::up;
}
static_assert(link_vector(4).z < 0 && link_vector(5).z == 0 && link_vector(12).z == 0 &&
              link_vector(13).z > 0);

/// The state that goes from one record of a packet to the next, and the grammar of records.
/// A copy is a snapshot. Coder has: bool code_bit(uint32_t context, bool bit).
template <class Coder>
class RegionModel {
 public:
  RegionModel() = default;
  /// The state that every packet begins with.
  explicit RegionModel(const Coder& coder) : coder_(coder), incidence_(no_incidence) {}

  Coder& coder() { return coder_; }
  const Coder& coder() const { return coder_; }

  RecordKind record_kind(RecordKind kind);

  /// A layer mark's slice.
  uint32_t layer(uint32_t slice) {
    before_ = Before::mark;
    return slice_ += plain_number(slice - slice_);
  }
  /// A number, a bit or some bits without a context.
  uint32_t plain_number(uint32_t value) { return number(context::even, 1, value + 1) - 1; }
  bool plain_bit(bool value) { return code_bit(context::even, value); }
  uint32_t plain_bits(uint32_t count, uint32_t value) {
    uint32_t coded = 0;
    while (count-- > 0) coded = 2 * coded + uint32_t{plain_bit((value >> count & 1) != 0)};
    return coded;
  }

  /// The normal, guessed from that of the record before.
  Incidence incidence(Incidence incidence);
  uint32_t ring_count(uint32_t count);
  /// Whether a fragment is told from its end: in the order of its links from the last to the first.
  ChainKind order(ChainKind kind) {
    const bool is_backwards = code_bit(context::is_backwards, kind == ChainKind::backwards);
    begin_chain(is_backwards ? ChainKind::backwards : ChainKind::fragment);
    return kind_;
  }
  /// Where a ring begins, relative to the vertex told last; after the incidence. Limit: an odd
  /// coordinate sum.
  Vertex start(const Vertex& start, ChainKind kind);
  /// After the first direction of a fragment: where it begins, or, told from its end, the vertex
  /// before the end. As start().
  Vertex fragment_vertex(const Vertex& vertex);
  /// The vertex told last.
  const Vertex& last_start() const { return start_; }
  bool parallelogram(bool is_parallelogram) {
    return code_bit(context::parallelogram + link_class_, is_parallelogram);
  }
  /// How many runs a ring has. Limit: at least 2.
  uint32_t run_count(uint32_t count) {
    using namespace context;
    return 1 + number(context::run_count + link_class_ * size_of_run_count, size_of_run_count,
                      count - 1);
  }
  /// Whether the link whose direction was told last is the last of a fragment.
  bool is_last_link(bool is_last) {
    return code_bit(
        context::is_last_link + (is_short() ? by_slope_and_level() : 2 * context::slopes), is_last);
  }
  /// A run's direction, or that by which a fragment's chain comes to its start. Decoding, any of 8
  /// may come back: see is_direction_of().
  Direction direction(Direction direction);
  /// Whether the last direction of a ring is that of the run before, or opposite to it.
  bool is_parallel() const { return turns_ == 1 || turns_ == 1 + direction_count() / 2; }
  /// A run's length, after its direction. Limit: at least 1, and decoding it is.
  uint32_t length(uint32_t length);

  /// A part of a region that is not compact, or of a fragment that is too long: part(), then
  /// item_kind() with direction() and length(), or with start(), for each item, and end_part()
  /// last.
  void part(Record& record);
  Item item_kind(Item kind) {
    if (code_bit(context::item_kind, kind == Item::run)) return Item::run;
    return code_bit(context::item_kind + 1, kind == Item::ring) ? Item::ring : Item::end;
  }
  bool end_part(bool is_last) { return code_bit(context::part_kind + 2, is_last); }

 private:
  bool code_bit(uint32_t context, bool value) { return coder_.code_bit(context, value); }
  uint32_t direction_count() const { return 4U + 2U * link_class_; }
  // Most fragments were cut after a few links. From then on one is told as a ring is.
  bool is_short() const { return is_fragment(kind_) && links_ <= max_of_short; }
  Rise rise() const { return rise_of(link_of(incidence_, direction_)); }
  uint32_t is_level() const { return rise() == Rise::level ? 1 : 0; }
  uint32_t by_slope_and_level() const { return 2U * slope_ + is_level(); }
  uint32_t tree_of_turn() const;
  Direction first_back() const;
  uint32_t tree(uint32_t first, uint32_t value);
  uint32_t number(uint32_t first, uint32_t contexts, uint32_t value);
  int32_t delta(uint32_t first, int32_t value);
  int32_t step(uint32_t row, int32_t to, int32_t& from);
  int32_t step_voxels(uint32_t row, int32_t to, int32_t& from, uint32_t parity);
  // The sum of the coordinates is odd.
  void step_x(uint32_t row, int32_t x) {
    step_voxels(row, x, start_.x, parity_of(start_.y ^ start_.z ^ 1));
  }
  // Rings start at their last vertex: the first direction of a region is told as a turn from the
  // first that leads back, any other from 0.
  void begin_chain(ChainKind kind) {
    direction_ = kind == ChainKind::first ? first_back() : Direction{0};
    links_ = 0;
    turns_ = 0;
    length_ = 0;
    kind_ = kind;
  }

  static constexpr uint8_t max_of_short = 6;
  enum class Before : uint8_t { mark, region, fragment };

  Coder coder_;
  Incidence incidence_ = 0;
  uint8_t link_class_ = 0;  // of its planes: diagonal, corner, axis
  uint8_t slope_ = 0;       // upright diagonal, corner, upright axis, tilted diagonal, level
  Before before_ = Before::mark;
  bool fragments_came_ = false;  // in this packet: then memory is short, and more will come
  // Of the chain:
  ChainKind kind_ = ChainKind::first;
  Direction direction_ = 0;
  uint8_t links_ = 0;   // whose direction was told, up to one more than max_of_short
  uint8_t turns_ = 0;   // the last turn and one more; 0 before the first
  uint8_t length_ = 0;  // of the last run, or 3 when it is longer; 0 before the first
  Vertex start_{0, 0, 0};
  uint32_t slice_ = 0;
};

/// The lengths of the two last runs of a ring, which follow from the way that is left.
struct Closure {
  bool is_valid;
  uint32_t first, second;
};

/// Closes a ring along directions u and v by `way`. When they are parallel the length along u is
/// `told`. Invalid where no two lengths of 1 to max_compact_length do it.
Closure close_ring(const Vertex& u, const Vertex& v, const Vertex& way, uint32_t first_length);

/// Rings with longer runs are told in parts.
constexpr uint32_t max_compact_length = 0xFFFF;

// ---- implementation ----

// Three bits. Nodes are numbered from 1, those below a node by twice its number and one more. Not
// inlined: it takes 200 bytes, and is called in three places.
template <class Coder>
DISCMC_NOINLINE uint32_t RegionModel<Coder>::tree(uint32_t first, uint32_t value) {
  uint32_t node = 1;
  for (uint32_t bits = 3; bits-- > 0;) {
    const uint32_t context = first == context::even ? first : first + node - 1;
    node = 2 * node + uint32_t{code_bit(context, (value >> bits & 1) != 0)};
  }
  return node - 8;
}

// A positive number by exponential Golomb code (J. Teuhola, 1978): its length in unary, then its
// lower bits.
template <class Coder>
uint32_t RegionModel<Coder>::number(uint32_t first, uint32_t contexts, uint32_t value) {
  const uint32_t last = first + contexts - 1;
  uint32_t bits = 0;
  for (uint32_t rest = value >> 1; code_bit(first, rest != 0) && bits < 31; ++bits, rest >>= 1)
    if (first < last) ++first;
  uint32_t coded = 1;
  while (bits-- > 0) coded = 2 * coded + uint32_t{plain_bit((value >> bits & 1) != 0)};
  return coded;
}

template <class Coder>
int32_t RegionModel<Coder>::delta(uint32_t first, int32_t value) {
  if (code_bit(first, value == 0)) return 0;
  // All ones for a negative number: x ^ sign - sign is its size, and of a size the number.
  const uint32_t sign = code_bit(first + 1, value < 0) ? ~uint32_t{0} : 0;
  const uint32_t size = (static_cast<uint32_t>(value) ^ sign) - sign;
  const uint32_t coded = number(first + 2, context::size_of_delta - 2, size);
  return static_cast<int32_t>((coded ^ sign) - sign);
}

// Takes a coordinate to where it is told to be. Returns by how much. The contexts from start_z on
// are rows for a delta each.
template <class Coder>
int32_t RegionModel<Coder>::step(uint32_t row, int32_t to, int32_t& from) {
  const int32_t sent =
      delta(context::start_z + row * context::size_of_delta,
            wrapped_difference(static_cast<uint32_t>(to), static_cast<uint32_t>(from)));
  from = wrapped_sum(from, sent);
  return sent;
}

// The same for one whose parity is known: only the half is told.
template <class Coder>
int32_t RegionModel<Coder>::step_voxels(uint32_t row, int32_t to, int32_t& from, uint32_t parity) {
  int32_t half = from >> 1;
  const int32_t sent = step(row, to >> 1, half);
  from = static_cast<int32_t>(static_cast<uint32_t>(half) << 1 | parity);
  return sent;
}

// Component by component, z first, each guessed from the record before.
template <class Coder>
Incidence RegionModel<Coder>::incidence(Incidence incidence) {
  // The components plus one are the digits to base 3.
  const auto take_digit = [](uint32_t& number) {
    const uint32_t digit = number * 57 >> 9;  // a ninth, up to 26
    number = 3 * (number - 9 * digit);
    return digit;
  };
  uint32_t sent = incidence;
  uint32_t before = incidence_;
  uint32_t coded = 0;
  // An axis and how many zeros came before: z 0, y 0 and 1, x 0 to 2.
  uint32_t row = 0;
  for (uint32_t rows = 1; rows <= 3; ++rows) {
    const uint32_t digit = take_digit(sent);
    const uint32_t by = 3 * row + take_digit(before);
    row += rows;
    uint32_t component = 1;
    if (by < 15 && code_bit(context::component_zero + by, digit == 1))
      ++row;
    else
      component = code_bit(context::component_sign + by, digit == 0) ? 0 : 2;
    coded = 3 * coded + component;
  }
  incidence_ = static_cast<Incidence>(coded);
  link_class_ = static_cast<uint8_t>(discmc::direction_count(incidence_) / 2U - 2);
  const bool is_upright = coded >= 9 && coded < 18;
  slope_ = static_cast<uint8_t>(is_upright || link_class_ == 1 ? link_class_ : 3 + link_class_ / 2);
  return incidence_;
}

// With memory to spare there are regions alone; when it is short, fragments by the dozen.
template <class Coder>
RecordKind RegionModel<Coder>::record_kind(RecordKind kind) {
  const uint32_t by = static_cast<uint32_t>(before_) + (fragments_came_ ? 2U : 0U);
  if (code_bit(context::region_follows + by, kind == RecordKind::region)) return RecordKind::region;
  if (code_bit(context::fragment_follows + by, kind == RecordKind::fragment))
    return RecordKind::fragment;
  constexpr uint32_t first = static_cast<uint32_t>(RecordKind::layer);
  return static_cast<RecordKind>(first +
                                 tree(context::other_kind, static_cast<uint32_t>(kind) - first));
}

template <class Coder>
uint32_t RegionModel<Coder>::ring_count(uint32_t count) {
  if (code_bit(context::one_ring + link_class_, count == 1)) return 1;
  return 2 + plain_number(count - 2);
}

template <class Coder>
Vertex RegionModel<Coder>::start(const Vertex& start, ChainKind kind) {
  using namespace context;
  // 6 rows of z, 6 of y, 10 of x, 3 of holes.
  const auto row = [kind](uint32_t of_first, uint32_t of_further) {
    return kind == ChainKind::first ? of_first : of_further;
  };
  const uint32_t after_mark = before_ == Before::mark ? 1 : 0;
  const int32_t dz = step(row(link_class_ + 3 * after_mark, 22), start.z, start_.z);
  const uint32_t from_2 = static_cast<uint32_t>(dz) + 2;
  const int32_t dy = step(row(6 + (from_2 < 5 ? from_2 : 5), 23), start.y, start_.y);
  const uint32_t by_y = dy < -2 ? 0U : dy > 2 ? 4U : static_cast<uint32_t>(dy + 2);
  step_x(row((from_2 - 1 < 3 ? 17U : 12U) + by_y, 24), start.x);
  before_ = Before::region;
  begin_chain(kind);
  return start_;
}

// Fragments are cut where links lead from slice to slice: the first link, the one that was cut,
// tells much about its vertex, and that lies where the sweep is.
template <class Coder>
Vertex RegionModel<Coder>::fragment_vertex(const Vertex& vertex) {
  using namespace context;
  const uint32_t order = kind_ == ChainKind::backwards ? 1 : 0;
  const uint32_t z{code_bit(z_is_odd + 6U * slope_ + 2 * static_cast<uint32_t>(rise()) + order,
                            parity_of(vertex.z) != 0)};
  const uint32_t y{code_bit(y_is_odd + 2U * slope_ + z, parity_of(vertex.y) != 0)};
  // Of z, y and x two rows each, which follow those of start().
  const int32_t dz = step_voxels(25 + (before_ == Before::mark ? 1U : 0U), vertex.z, start_.z, z);
  const int32_t dy = step_voxels(27 + (dz != 0 ? 1U : 0U), vertex.y, start_.y, y);
  step_x(29 + (dy != 0 ? 1U : 0U), vertex.x);
  before_ = Before::fragment;
  fragments_came_ = true;
  return start_;
}

// A direction is told as a turn from the one before. Told backwards, a chain still turns as it does
// forwards.
template <class Coder>
Direction RegionModel<Coder>::direction(Direction direction) {
  if (links_ <= max_of_short) ++links_;
  const uint32_t directions = direction_count();
  const bool mirrors = kind_ == ChainKind::backwards && links_ > 1;
  const uint32_t from = mirrors ? direction : direction_;
  const uint32_t to = mirrors ? direction_ : direction;
  const uint32_t turn = tree(tree_of_turn(), to - from + (to < from ? directions : 0));
  if (turn >= directions) return static_cast<Direction>(turn);  // none of the plane's
  if (links_ > 1) turns_ = static_cast<uint8_t>(turn + 1);
  const uint32_t next = direction_ + (mirrors ? directions - turn : turn);
  direction_ = static_cast<Direction>(next < directions ? next : next - directions);
  return direction_;
}

template <class Coder>
uint32_t RegionModel<Coder>::tree_of_turn() const {
  using namespace context;
  if (links_ == 1) {
    if (kind_ == ChainKind::further) return even;
    return (is_fragment(kind_) ? fragment_direction : first_direction) + slope_ * size_of_tree;
  }
  if (is_short()) return fragment_turn + by_slope_and_level() * size_of_tree;
  // A class has a tree for each turn before and one for none: 5, 7 or 9.
  return next_turn + (link_class_ * (link_class_ + 4U) + turns_) * size_of_tree;
}

// The first, counter-clockwise, of the directions that lead back in the order z, y, x. The last of
// them is 0, or comes after it.
template <class Coder>
Direction RegionModel<Coder>::first_back() const {
  uint32_t direction = direction_count();
  while (link_of(incidence_, static_cast<Direction>(direction - 1)) < link_codes / 2) --direction;
  return static_cast<Direction>(direction);
}

template <class Coder>
uint32_t RegionModel<Coder>::length(uint32_t length) {
  using namespace context;
  const bool is_axis_link = link_class_ == 2 && direction_ % 2 == 0;
  const uint32_t kind = is_axis_link ? 3U : link_class_;
  const uint32_t first = is_short() ? fragment_length + (2 * kind + is_level()) * size_of_run_length
                                    : run_length + (4 * kind + length_) * size_of_run_length;
  const uint32_t coded = number(first, size_of_run_length, length);
  length_ = static_cast<uint8_t>(coded < 3 ? coded : 3);
  return coded;
}

template <class Coder>
void RegionModel<Coder>::part(Record& record) {
  record.is_fragment = code_bit(context::part_kind, record.is_fragment);
  record.continues = code_bit(context::part_kind + 1, record.continues);
  record.incidence = incidence(record.incidence);
  if (record.is_fragment && !record.continues)
    record.incoming = static_cast<Direction>(tree(context::even, record.incoming));
  begin_chain(ChainKind::further);
}

}  // namespace discmc

#endif
