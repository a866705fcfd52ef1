// What the symbols of a packet of records mean: how regions, loose fragments and marks are told.
//
// The same functions encode and decode: a Coder's symbol(row, symbol) writes the symbol it is given
// and returns it, or ignores it and returns the one it reads; so does even(bits, value). Each
// function returns what was coded. How likely a symbol is stands in a row of shares
// (record_model.cpp), found by training; nothing is learnt on the way, so that every packet decodes
// alone.
#ifndef DISCMC_STREAM_RECORD_MODEL_HPP
#define DISCMC_STREAM_RECORD_MODEL_HPP

#include <discmc/stream/range_coder.hpp>
#include <discmc/stream/record.hpp>

namespace discmc::stream {

/// What a record is.
enum class RecordKind : uint8_t {
  region,     ///< of one ring
  forwards,   ///< a loose fragment, told from its start
  backwards,  ///< one that is told from its end
  holed,      ///< a region of several rings
  layer,
  part,  ///< of a region or fragment
  end,   ///< of the packet
  skipped,
  extension
};

constexpr bool is_fragment(RecordKind kind) {
  return kind == RecordKind::forwards || kind == RecordKind::backwards;
}

/// Where a chain begins, seen from the vertex told last: how many voxels further in the row, if
/// they are few, or how much of the way is told.
namespace place {

constexpr uint32_t ahead = 8;  ///< further in the row
constexpr uint32_t behind = ahead + 1;
constexpr uint32_t next_row = behind + 1;
constexpr uint32_t row_before = next_row + 1;
constexpr uint32_t elsewhere = row_before + 1;
constexpr uint32_t count = elsewhere + 1;

}  // namespace place

/// Rows of shares, all of one size and one after another.
struct Rows {
  uint32_t first;
  uint32_t size;
  uint32_t count;
  constexpr uint32_t operator[](uint32_t i) const { return first + size * i; }
  constexpr uint32_t end() const { return first + size * count; }
};

namespace rows {

constexpr uint32_t of_number = 11;
constexpr uint32_t headings_and_other = 10;
constexpr uint32_t directions = 4 + 6 + 8;  ///< a row for each class, of its directions
constexpr uint32_t corners_of_classes = 2 + 8 + 27;
constexpr uint32_t turns_of_classes = 3 * 2 * 4 + 3 * 2 * 6 + 6 * 2 * 8;

constexpr Rows kinds{0, 9, 5};                             ///< by what came before
constexpr Rows places{kinds.end(), place::count, 2};       ///< of a region, a fragment
constexpr Rows axes{places.end(), 4, 12};                  ///< by distance, axis before
constexpr Rows steps{axes.end(), of_number, 7};            ///< x by place from `ahead` on; y; z
constexpr Rows headings{steps.end(), headings_and_other, 18};              ///< by vertex, heading before
constexpr Rows corners{headings.end(), corners_of_classes, 1};             ///< by class
constexpr Rows first_directions{corners.end(), 9, 3};      ///< by class; of 2, 3 and 4 symbols
constexpr Rows two_lengths{first_directions.end(), 16, 6}; ///< by class, parallelogram
constexpr Rows lengths{two_lengths.end(), of_number, 4};   ///< by kind of link
constexpr Rows longer{lengths.end(), of_number, 4};        ///< likewise
constexpr Rows run_counts{longer.end(), of_number, 3};     ///< by class
constexpr Rows turns{run_counts.end(), turns_of_classes, 1};  ///< by class, parity, side before
constexpr Rows last_turns{turns.end(), directions, 1};        ///< by class, as the next two
constexpr Rows cut_turns{last_turns.end(), directions, 2};    ///< by whether it is level
constexpr Rows cut_directions{cut_turns.end(), directions, 2};  ///< by whether the axis is z
constexpr Rows is_last{cut_directions.end(), 2, 4};             ///< by level, order
constexpr Rows plain{is_last.end(), of_number, 1};

}  // namespace rows

/// How much lies below each symbol of each row, in 256ths; then a 0.
extern const uint8_t shares[rows::plain.end() + 1];

// Differences wrap: any 32-bit coordinates come through. Units: voxels, of 31 bits.
constexpr int32_t voxels_between(int32_t to, int32_t from) {
  const uint32_t voxels = static_cast<uint32_t>(to >> 1) - static_cast<uint32_t>(from >> 1);
  return static_cast<int32_t>(voxels << 1) >> 1;
}
constexpr int32_t voxels_beyond(int32_t from, int32_t voxels, uint32_t parity) {
  return static_cast<int32_t>(
      (static_cast<uint32_t>(from >> 1) + static_cast<uint32_t>(voxels)) << 1 | parity);
}

/// The axis of the edge that a vertex is the middle of; 3 for a centroid.
constexpr uint32_t axis_of(const Vertex& v) {
  const uint32_t odd = (static_cast<uint32_t>(v.x) & 1) | (static_cast<uint32_t>(v.y) & 1) << 1 |
                       (static_cast<uint32_t>(v.z) & 1) << 2;
  return odd >> 1;
}

/// An incidence seen along an axis: its component there, plus one, and the two others, the lesser
/// axis first, plus one each, as digits to base 3.
struct Heading {
  uint32_t along;
  uint32_t across;
};
constexpr uint32_t level_heading = 4;

constexpr Heading heading_of(Incidence incidence, uint32_t axis) {
  const uint32_t z = incidence * 57U >> 9;  // a ninth, up to 26
  const uint32_t xy = incidence - 9U * z;
  const uint32_t y = xy * 11U >> 5;  // a third, up to 8
  const uint32_t x = xy - 3 * y;
  if (axis == 0) return {x, y + 3 * z};
  if (axis == 1) return {y, x + 3 * z};
  return {z, xy};
}
constexpr Incidence incidence_of(const Heading& heading, uint32_t axis) {
  const uint32_t high = heading.across / 3;
  const uint32_t low = heading.across % 3;
  const uint32_t code = axis == 0   ? heading.along + 3 * low + 9 * high
                        : axis == 1 ? low + 3 * heading.along + 9 * high
                                    : low + 3 * high + 9 * heading.along;
  return static_cast<Incidence>(code);
}

/// The class of an incidence's planes: 0 for diagonal ones, 1 for corners, 2 for those across an
/// axis.
constexpr uint32_t class_of(Incidence incidence) {
  return discmc::direction_count(incidence) / 2U - 2;
}
/// Where a class begins, in a list of the directions of all classes.
constexpr uint32_t first_of_class(uint32_t link_class) {
  return link_class * (link_class + 3);
}

/// What a link along a direction does to two coordinates of the plane, by class: a ring is closed
/// where they add up to none.
struct PlaneStep {
  int8_t u, v;
};
inline constexpr PlaneStep plane_steps[] = {
    {1, 0}, {0, 1}, {-1, 0}, {0, -1},                                        // diagonal
    {1, 0}, {0, 1}, {-1, 1}, {-1, 0}, {0, -1}, {1, -1},                      // corner
    {2, 0}, {1, 1}, {0, 2},  {-1, 1}, {-2, 0}, {-1, -1}, {0, -2}, {1, -1}};  // axis

/// Whether two directions of so many are the same, or opposite.
constexpr bool are_parallel(uint32_t directions, uint32_t a, uint32_t b) {
  const uint32_t difference = a < b ? b - a : a - b;
  return difference == 0 || 2 * difference == directions;
}

/// The first, counter-clockwise, of the directions that lead back in the order z, y, x; the number
/// of directions where that is direction 0.
constexpr uint32_t first_back(Incidence incidence) {
  const uint32_t half = discmc::direction_count(incidence) / 2U;
  const Link* const first_half = links.link[incidence];
  // Links of the second half are opposite to those of the first, and direction 0 leads back.
  uint32_t forth = half;
  while (first_half[forth - 1] >= link_codes / 2) --forth;
  return half + forth;
}

/// Runs of whole regions and rings are at most so long; what is longer goes in parts.
constexpr uint32_t max_compact_length = 0xFFFF;

/// The state that goes from one record of a packet to the next, and the grammar of records.
/// A copy is a snapshot. Coder has: bool writes, uint32_t symbol(uint32_t row, uint32_t symbol),
/// uint32_t even(uint32_t bits, uint32_t value) for up to 8 bits.
template <class Coder>
class RecordModel {
 public:
  RecordModel() = default;
  /// The state that every packet begins with.
  explicit RecordModel(const Coder& coder) : coder_(coder), incidence_(no_incidence) {}

  Coder& coder() { return coder_; }
  const Coder& coder() const { return coder_; }

  RecordKind record_kind(RecordKind kind);

  /// A layer mark's slice.
  uint32_t layer(uint32_t slice) {
    before_ = Before::mark;
    return slice_ += plain_number(slice - slice_);
  }
  /// A number of up to 2^32 - 2.
  uint32_t plain_number(uint32_t value) { return number(rows::plain[0], value + 1) - 1; }
  /// Bits that are as likely as not, up to 31.
  uint32_t even(uint32_t bits, uint32_t value);

  /// Where a chain begins, relative to the vertex told last. Limit: an odd coordinate sum.
  Vertex start(const Vertex& start, bool of_fragment);
  /// The vertex told last.
  const Vertex& last_start() const { return start_; }
  /// The normal, guessed from that of the record before. Decoding, it may be none.
  Incidence incidence(Incidence incidence);

  // ---- a ring ----

  /// Three or four corners as one symbol; 0 where the ring is told run by run.
  uint32_t corners(uint32_t corners) {
    return symbol(rows::corners.first + link_class_ * (3 * link_class_ - 1), corners);
  }
  /// The first direction. closing: the turn by which the ring comes to it, if it is less than 4 and
  /// the direction is one of as many that lead back.
  Direction ring_direction(Direction direction, uint32_t closing);
  /// The first two lengths of a ring of four corners. Limit: 1 to 4 each, 4 for all that are longer.
  uint32_t two_lengths(bool is_parallelogram, uint32_t lengths) {
    return symbol(rows::two_lengths[2 * link_class_ + (is_parallelogram ? 1U : 0U)], lengths);
  }
  uint32_t run_count(uint32_t count) { return number(rows::run_counts[link_class_], count); }
  /// The direction of one of the last two runs, whose lengths follow from the others.
  Direction last_direction(Direction direction) {
    return turn_from(rows::last_turns[0], direction);
  }

  // ---- any chain ----

  /// The first direction of a fragment, and of a part.
  Direction cut_direction(Direction direction) {
    return begin_with(symbol(direction_row(rows::cut_directions[axis_ == 2 ? 1 : 0]), direction));
  }
  Direction plain_direction(Direction direction) { return begin_with(even(3, direction)); }
  /// The direction beside the link by which a fragment's chain comes to its start.
  Direction cut_turn(Direction direction) {
    return turn_from(rows::cut_turns[is_level()], direction);
  }
  /// The length of the run whose direction was told, all of it or what is more than `told`.
  uint32_t length(uint32_t length) { return number(rows::lengths[kind_of_link()], length); }
  uint32_t longer(uint32_t more) { return number(rows::longer[kind_of_link()], more); }
  /// A run after another one. Decoding, an empty one when it is too long.
  Run run(Run run);
  /// Whether the run that was told last is the last one.
  bool is_last_run(bool is_last) {
    return symbol(rows::is_last[2 * (is_backwards_ ? 1U : 0U) + is_level()], is_last ? 1 : 0) != 0;
  }

  /// What a part is of, and whether it begins with a ring. Returns that.
  bool part(Record& record, bool begins_ring);

  uint32_t direction_count() const { return 4U + 2U * link_class_; }
  uint32_t link_class() const { return link_class_; }
  /// Sets the direction from which the next one is told.
  void set_direction(Direction direction) { direction_ = direction; }

 private:
  enum class Before : uint8_t { mark, region, fragment };

  uint32_t symbol(uint32_t row, uint32_t symbol) { return coder_.symbol(row, symbol); }
  // A row of a symbol for each direction of the class.
  uint32_t direction_row(uint32_t first) const { return first + first_of_class(link_class_); }
  uint32_t number(uint32_t row, uint32_t value);
  int32_t step(uint32_t row, int32_t voxels);
  void set_incidence(Incidence incidence);
  uint32_t kind_of_link() const {
    return link_class_ == 2 && direction_ % 2 == 0 ? 3 : link_class_;
  }
  // Whether the link told last stays within its slice. Links are numbered in the order of z: 5 lead
  // down, 8 are level, 5 lead up.
  uint32_t is_level() const {
    return static_cast<uint32_t>(link_of(incidence_, direction_)) - 5 < 8 ? 1 : 0;
  }
  Direction begin_with(uint32_t direction) {
    side_ = 0;
    return direction_ = static_cast<Direction>(direction);
  }
  uint32_t turn_to(Direction direction) const;
  Direction turn_by(uint32_t turn);
  Direction turn_from(uint32_t row, Direction direction) {
    return turn_by(symbol(direction_row(row), turn_to(direction)));
  }

  Coder coder_;
  Incidence incidence_ = 0;
  uint8_t link_class_ = 0;
  Before before_ = Before::mark;
  bool fragments_came_ = false;  // in this packet: then memory is short, and more will come
  uint8_t axis_ = 0;             // of the vertex told last
  uint8_t axis_before_ = 0;      // and of the one before
  bool is_same_voxel_ = false;   // as that one's
  bool is_backwards_ = false;    // a chain that still turns as it does forwards
  Direction direction_ = 0;
  uint8_t side_ = 0;  // of the last turn: 1 left, 2 right, 0 neither or none
  Vertex start_{0, 0, 0};
  uint32_t slice_ = 0;
};

// ---- implementation ----

template <class Coder>
uint32_t RecordModel<Coder>::even(uint32_t bits, uint32_t value) {
  uint32_t coded = 0;
  while (bits > 0) {
    const uint32_t taken = bits < 8 ? bits : 8;
    bits -= taken;
    coded = coded << taken | coder_.even(taken, value >> bits);
  }
  if constexpr (Coder::writes) return value;
  return coded;
}

// A positive number: 1, 2, 3, or how many bits follow the highest one, and these.
template <class Coder>
uint32_t RecordModel<Coder>::number(uint32_t row, uint32_t value) {
  constexpr uint32_t last = rows::of_number - 1;
  uint32_t bits = 1;
  while (value >> bits > 1) ++bits;
  uint32_t size = value < 4 ? value - 1 : bits + 1;
  size = symbol(row, size < last ? size : last);
  if (size < 3) return Coder::writes ? value : size + 1;
  bits = size == last ? even(5, bits) : size - 1;
  const uint32_t rest = even(bits, value);
  return Coder::writes ? value : uint32_t{1} << bits | rest;
}

// Of either sign: 0, -1, 1, -2, ...
template <class Coder>
int32_t RecordModel<Coder>::step(uint32_t row, int32_t voxels) {
  const uint32_t twice = static_cast<uint32_t>(voxels) << 1;
  const uint32_t coded = number(row, (voxels < 0 ? ~twice : twice) + 1) - 1;
  if constexpr (Coder::writes) return voxels;
  return static_cast<int32_t>(coded >> 1 ^ (0 - (coded & 1)));
}

// With memory to spare there are regions alone; when it is short, fragments by the dozen.
template <class Coder>
RecordKind RecordModel<Coder>::record_kind(RecordKind kind) {
  const uint32_t by = static_cast<uint32_t>(before_) + (fragments_came_ ? 2U : 0U);
  kind = static_cast<RecordKind>(symbol(rows::kinds[by], static_cast<uint32_t>(kind)));
  if (is_fragment(kind)) fragments_came_ = true;
  if (kind <= RecordKind::holed) before_ = is_fragment(kind) ? Before::fragment : Before::region;
  is_backwards_ = kind == RecordKind::backwards;
  return kind;
}

// Chains are told where the sweep is: nearly all begin in the row of the vertex told last or in the
// next one.
template <class Coder>
Vertex RecordModel<Coder>::start(const Vertex& start, bool of_fragment) {
  using namespace place;
  int32_t x = voxels_between(start.x, start_.x);
  int32_t y = voxels_between(start.y, start_.y);
  int32_t z = voxels_between(start.z, start_.z);
  uint32_t place = elsewhere;
  if (z == 0 && y == 0)
    place = x < 0 ? behind : static_cast<uint32_t>(x) < ahead ? static_cast<uint32_t>(x) : ahead;
  else if (z == 0 && y == 1)
    place = next_row;
  else if (z == 0 && y == -1)
    place = row_before;
  place = symbol(rows::places[of_fragment ? 1 : 0], place);
  if constexpr (!Coder::writes) {
    x = static_cast<int32_t>(place);
    y = place == next_row ? 1 : place == row_before ? -1 : 0;
    z = 0;
  }
  if (place >= ahead) {
    if (place == elsewhere) {
      z = step(rows::steps[6], z);
      y = step(rows::steps[5], y);
    }
    const uint32_t row = rows::steps[place - ahead];
    if (place == ahead)
      x = static_cast<int32_t>(number(row, static_cast<uint32_t>(x) - ahead + 1) + ahead - 1);
    else if (place == behind)
      x = static_cast<int32_t>(0 - number(row, 0 - static_cast<uint32_t>(x)));
    else
      x = step(row, x);
  }
  const uint32_t distance = place == 0 ? 0 : place < 3 ? 1 : 2;
  const uint32_t axis = symbol(rows::axes[4 * distance + axis_], axis_of(start));
  axis_before_ = axis_;
  axis_ = static_cast<uint8_t>(axis);
  is_same_voxel_ = place == 0;
  if constexpr (Coder::writes) return start_ = start;
  const uint32_t odd = axis == 3 ? 7 : 1U << axis;
  start_ = {voxels_beyond(start_.x, x, odd & 1), voxels_beyond(start_.y, y, odd >> 1 & 1),
            voxels_beyond(start_.z, z, odd >> 2)};
  return start_;
}

// The normals around a vertex on an edge all have one sign along it, and so have those on the other
// edges of its voxel. Across the edge it is guessed from the one before: on and off are alike.
template <class Coder>
Incidence RecordModel<Coder>::incidence(Incidence incidence) {
  constexpr uint32_t other = rows::headings_and_other - 1;
  uint32_t code = other;
  if (axis_ < 3) {
    const Heading to = heading_of(incidence, axis_);
    uint32_t sign = 1;
    if (is_same_voxel_ && axis_before_ < 3) sign = heading_of(incidence_, axis_before_).along;
    if (sign == 1) sign = 2 * even(1, to.along >> 1);
    const auto seen = [sign](uint32_t across) { return sign == 0 ? 8 - across : across; };
    const uint32_t from = seen(heading_of(incidence_, axis_).across);
    const bool is_same_vertex = is_same_voxel_ && axis_ == axis_before_;
    code = symbol(rows::headings[from + (is_same_vertex ? 0U : 9U)],
                  to.along == sign ? seen(to.across) : other);
    if constexpr (!Coder::writes)
      if (code < other) incidence = incidence_of({sign, seen(code)}, axis_);
  }
  if (code == other) incidence = static_cast<Incidence>(even(5, incidence));
  set_incidence(incidence);
  return incidence;
}

template <class Coder>
void RecordModel<Coder>::set_incidence(Incidence incidence) {
  if (!Coder::writes && !is_incidence(incidence)) return;
  incidence_ = incidence;
  link_class_ = static_cast<uint8_t>(class_of(incidence));
}

template <class Coder>
bool RecordModel<Coder>::part(Record& record, bool begins_ring) {
  const auto told = [this](bool value) { return even(1, value ? 1 : 0) != 0; };
  record.is_fragment = told(record.is_fragment);
  record.continues = told(record.continues);
  record.is_last = told(record.is_last);
  begins_ring = told(begins_ring);
  record.incidence = static_cast<Incidence>(even(5, record.incidence));
  set_incidence(record.incidence);
  if (record.is_fragment && !record.continues)
    record.incoming = static_cast<Direction>(even(3, record.incoming));
  return begins_ring;
}

template <class Coder>
Direction RecordModel<Coder>::ring_direction(Direction direction, uint32_t closing) {
  const uint32_t back = first_back(incidence_);
  uint32_t from = 0;
  if (closing > 1) {
    from = direction - back + (direction < back ? direction_count() : 0);
    // Rows of two, three and four symbols.
    const uint32_t row = rows::first_directions[link_class_] + closing * (closing - 1) / 2 - 1;
    from = symbol(row, from < 3 ? from : 3);
    if (from == 3) return plain_direction(direction);
  }
  if constexpr (Coder::writes) return begin_with(direction);
  from += back;
  return begin_with(from < direction_count() ? from : from - direction_count());
}

template <class Coder>
uint32_t RecordModel<Coder>::turn_to(Direction direction) const {
  const uint32_t from = is_backwards_ ? direction : direction_;
  const uint32_t to = is_backwards_ ? direction_ : direction;
  return to - from + (to < from ? direction_count() : 0);
}

template <class Coder>
Direction RecordModel<Coder>::turn_by(uint32_t turn) {
  const uint32_t directions = direction_count();
  side_ = turn == 0 ? 0 : 2 * turn < directions ? 1 : 2;
  const uint32_t next = direction_ + (is_backwards_ ? directions - turn : turn);
  return direction_ = static_cast<Direction>(next < directions ? next : next - directions);
}

// The turn, and whether the run is longer than one link, as one symbol.
template <class Coder>
Run RecordModel<Coder>::run(Run run) {
  const uint32_t parity = link_class_ == 2 ? direction_ & 1 : 0;
  const uint32_t row = rows::turns.first + link_class_ * (6 * link_class_ + 18) +
                       2 * direction_count() * (3 * parity + side_);
  const uint32_t code =
      symbol(row, 2 * turn_to(run.direction()) + (run.length() > 1 ? 1U : 0U));
  const Direction direction = turn_by(code >> 1);
  if (code % 2 == 0) return Run::straight(direction, 1);
  const uint32_t more = longer(run.length() - 1);
  return more < Run::max_length ? Run::straight(direction, 1 + more) : Run();
}

}  // namespace discmc::stream

#endif
