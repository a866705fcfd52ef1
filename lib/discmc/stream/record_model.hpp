// The symbols and contexts of records; record_writing.hpp and record_reading.cpp define their
// order.
//
// The same functions encode and decode, and each returns what was coded. A writing Coder writes the
// argument of symbol(context, symbol) and returns it. A reading Coder ignores the argument and
// returns the symbol that it reads. raw_bits(bits, value) works likewise, with all values equally
// likely.
//
// A context is a distribution of symbols, trained on scans (frequencies.hpp). The model selects it
// by what it coded before: the last vertex, incidence and direction. Contexts do not adapt, and
// every packet begins with the same state, so every packet decodes alone.
#ifndef DISCMC_STREAM_RECORD_MODEL_HPP
#define DISCMC_STREAM_RECORD_MODEL_HPP

#include <discmc/stream/frequencies.hpp>
#include <discmc/stream/range_coder.hpp>
#include <discmc/stream/record.hpp>

namespace discmc::detail::stream {

/// The kind of a record.
enum class RecordKind : uint8_t {
  region,     ///< of one ring
  holed,      ///< of several rings
  forwards,   ///< a loose fragment, coded from its start
  backwards,  ///< a loose fragment, coded from its end
  layer,      ///< a mark: regions are complete up to a slice
  part,       ///< of a region or fragment
  end,        ///< of the packet
  skipped,    ///< a mark: rows without samples
  extension   ///< contents that a decoder may skip
};

// Differences wrap, so any 32-bit coordinates can be coded. Units: voxels, of 31 bits.
constexpr int32_t voxels_between(int32_t to, int32_t from) {
  const uint32_t voxels = static_cast<uint32_t>(to >> 1) - static_cast<uint32_t>(from >> 1);
  return static_cast<int32_t>(voxels << 1) >> 1;
}
constexpr int32_t voxels_beyond(int32_t from, int32_t voxels, uint32_t parity) {
  return static_cast<int32_t>(
      (static_cast<uint32_t>(from >> 1) + static_cast<uint32_t>(voxels)) << 1 | parity);
}

/// Maps a signed number to a positive one, in the order 0, -1, 1, -2, ...
constexpr uint32_t positive_of(int32_t number) {
  const uint32_t twice = static_cast<uint32_t>(number) << 1;
  return (number < 0 ? ~twice : twice) + 1;
}
constexpr int32_t signed_of(uint32_t positive) {
  const uint32_t number = positive - 1;
  return static_cast<int32_t>(number >> 1 ^ (0 - (number & 1)));
}

/// An incidence, seen along an axis. along: its component on the axis, plus one. heading: the other
/// two components, plus one each, as digits of base 3; the later axis has the high digit.
struct IncidenceOnAxis {
  uint32_t along;
  uint32_t heading;
};

constexpr IncidenceOnAxis on_axis(Incidence incidence, uint32_t axis) {
  const uint32_t z = incidence * 57U >> 9;  // a ninth, up to 26
  const uint32_t xy = incidence - 9U * z;
  const uint32_t y = xy * 11U >> 5;  // a third, up to 8
  const uint32_t x = xy - 3 * y;
  if (axis == 0) return {x, y + 3 * z};
  if (axis == 1) return {y, x + 3 * z};
  return {z, xy};
}
constexpr Incidence incidence_of(const IncidenceOnAxis& incidence, uint32_t axis) {
  const uint32_t high = incidence.heading / 3;
  const uint32_t low = incidence.heading % 3;
  if (axis == 0) return static_cast<Incidence>(incidence.along + 3 * low + 9 * high);
  if (axis == 1) return static_cast<Incidence>(low + 3 * incidence.along + 9 * high);
  return static_cast<Incidence>(low + 3 * high + 9 * incidence.along);
}

/// Returns the class of an incidence: 0 diagonal, 1 corner, 2 along an axis.
constexpr uint32_t class_of(Incidence incidence) {
  return direction_count(incidence) / 2U - 2;
}

/// A link along each direction in two coordinates of the plane, by class. A ring is closed if its
/// steps add up to zero.
struct PlaneStep {
  int8_t u, v;
};
inline constexpr PlaneStep plane_steps[] = {
    {1, 0}, {0, 1}, {-1, 0}, {0, -1},                                        // diagonal
    {1, 0}, {0, 1}, {-1, 1}, {-1, 0}, {0, -1}, {1, -1},                      // corner
    {2, 0}, {1, 1}, {0, 2},  {-1, 1}, {-2, 0}, {-1, -1}, {0, -2}, {1, -1}};  // axis
constexpr const PlaneStep* plane_steps_of(uint32_t incidence_class) {
  return &plane_steps[size_t{incidence_class} * (incidence_class + 3)];
}

/// Returns the turn to the left from one direction to another.
constexpr uint32_t turn_between(uint32_t directions, uint32_t from, uint32_t to) {
  return to - from + (to < from ? directions : 0);
}

/// The first direction, counter-clockwise, that leads back in the order z, y, x: the opposite of
/// the first that leads forth. Direction 0 is returned as the number of directions.
constexpr uint32_t first_back(Incidence incidence) {
  const uint32_t half = direction_count(incidence) / 2U;
  const Link* const first_half = detail::link_table.link[incidence];
  // Links of the second half are opposite to those of the first, and direction 0 leads back.
  uint32_t first_forth = half;
  while (first_half[first_forth - 1] >= link_codes / 2) --first_forth;
  return half + first_forth;
}

/// The maximum length of a run in a whole region. A region with a longer run is sent in parts.
constexpr uint32_t max_compact_length = 0xFFFF;

/// Codes the symbols of records. Its state continues from record to record of a packet. A copy is a
/// snapshot. Coder has: bool writes, uint32_t symbol(uint32_t context, uint32_t symbol),
/// uint32_t raw_bits(uint32_t bits, uint32_t value) for up to 8 bits.
template <class Coder>
class RecordModel {
 public:
  RecordModel() = default;
  /// The state that every packet begins with.
  explicit RecordModel(const Coder& coder) : coder_(coder), incidence_(no_incidence) {}

  Coder& coder() { return coder_; }
  const Coder& coder() const { return coder_; }

  RecordKind record_kind(RecordKind kind);

  /// Codes the slice of a layer mark.
  uint32_t layer(uint32_t slice) { return slice_ += plain_number(slice - slice_); }
  /// Codes a number of up to 2^32 - 2.
  uint32_t plain_number(uint32_t value) { return number(contexts::plain, value + 1) - 1; }
  /// Codes up to 32 bits, all values equally likely.
  uint32_t raw_bits(uint32_t bits, uint32_t value);

  /// Codes the start of a chain, relative to the last coded vertex. Limit: an odd coordinate sum.
  Vertex start(const Vertex& start);
  /// Returns the last coded vertex.
  const Vertex& last_start() const { return start_; }
  /// Codes the incidence, predicted from the previous record's. A decoded one may be none.
  Incidence incidence(Incidence incidence);

  // ---- a ring ----

  /// Codes three or four corners as one symbol; 0 if the ring is coded run by run. Otherwise the
  /// symbol is 1 + d0 + d1 n + d2 n^2, with n = incidence_class() + 1 and di = turn i less 1.
  uint32_t corners(uint32_t corners) {
    return class_symbol(contexts::corners(incidence_class_), corners);
  }
  /// Codes the distance of the first direction from the first direction that leads back.
  uint32_t ring_direction(uint32_t from);
  /// Codes the first two lengths of a ring of four corners: 4 * (first - 1) + second - 1. Limit: 1
  /// to 4 each; 4 means 4 or more.
  uint32_t two_lengths(uint32_t lengths) { return class_symbol(contexts::two_lengths, lengths); }

  // ---- any chain ----

  void begin_chain(Direction first) { direction_ = first; }
  /// Codes the first direction of a fragment or a part, or the direction on the other side of the
  /// vertex where it was cut.
  Direction chain_direction(Direction direction) {
    if (direction_ != no_direction) return turn_from(contexts::cut_turn + level_bit(), direction);
    return direction_ =
               static_cast<Direction>(direction_symbol(contexts::first_direction, direction));
  }
  /// Codes the length of a run along a direction, or the rest of its length.
  uint32_t length(uint32_t context, Direction direction, uint32_t length) {
    const uint32_t kind = incidence_class_ == 2 && direction % 2 == 0 ? 3 : incidence_class_;
    return number(context + contexts::of_number * kind, length);
  }
  /// Codes a run after another one. A decoded run is empty if it is too long.
  Run run(Run run);
  /// Codes whether the last coded run is the last of its chain.
  bool is_last_run(bool is_last) {
    return symbol(contexts::is_last + 4 * chain_ + 2 * level_bit(), is_last ? 1 : 0) != 0;
  }

  /// Codes the header of a part, and sets it in the record. Returns whether the part begins a ring.
  bool part(Record& record, bool begins_ring);

  uint32_t incidence_class() const { return incidence_class_; }
  uint32_t directions() const { return 4U + 2U * incidence_class_; }
  bool is_backwards() const { return chain_ == backwards; }

 private:
  uint32_t symbol(uint32_t context, uint32_t symbol) { return coder_.symbol(context, symbol); }
  // Codes a symbol in a context of the class. context: its offset in the block of the class.
  uint32_t class_symbol(uint32_t context, uint32_t symbol) {
    return this->symbol(class_contexts_ + context, symbol);
  }
  // Codes a symbol in a context of directions. context: its offset in directions.
  uint32_t direction_symbol(uint32_t context, uint32_t symbol) {
    return class_symbol(contexts::by_direction + context * directions(), symbol);
  }
  uint32_t number(uint32_t context, uint32_t value);
  void set_incidence(Incidence incidence);
  // Returns 1 if the last coded link stays within its slice, otherwise 0. Links are numbered in the
  // order of z: 5 lead down, 8 are level, 5 lead up. The second half is opposite to the first.
  uint32_t level_bit() const {
    const uint32_t half = directions() / 2;
    const uint32_t link =
        detail::link_table.link[incidence_][direction_ < half ? direction_ : direction_ - half];
    return link - 5 < 8 ? 1 : 0;
  }
  uint32_t turn_to(Direction direction) const {
    return is_backwards() ? turn_between(directions(), direction, direction_)
                          : turn_between(directions(), direction_, direction);
  }
  Direction turn_by(uint32_t turn);
  Direction turn_from(uint32_t context, Direction direction) {
    return turn_by(direction_symbol(context, turn_to(direction)));
  }

  // Chains coded in their own order, chains coded backwards, and rings up to the last run.
  static constexpr uint8_t forwards = 0, backwards = 1, ring = 2;

  Coder coder_;
  Incidence incidence_ = 0;
  uint8_t incidence_class_ = 0;
  uint16_t class_contexts_ = 0;
  // Whether this packet has had loose fragments, which makes more of them likely: 0 no, 1 before
  // the last record, 2 including it.
  uint8_t fragments_ = 0;
  uint8_t axis_ = 0;            // of the last coded vertex
  uint8_t axis_before_ = 0;     // of the vertex before that one
  bool is_same_voxel_ = false;  // whether the two vertices have the same voxel
  uint8_t chain_ = forwards;    // forwards, backwards or ring
  Direction direction_ = 0;
  Vertex start_{0, 0, 0};
  uint32_t slice_ = 0;
};

// ---- implementation ----

template <class Coder>
uint32_t RecordModel<Coder>::raw_bits(uint32_t bits, uint32_t value) {
  uint32_t coded = 0;
  while (bits > 0) {
    const uint32_t part_bits = bits < 8 ? bits : 8;
    bits -= part_bits;
    coded = coded << part_bits | coder_.raw_bits(part_bits, value >> bits);
  }
  if constexpr (Coder::writes) return value;
  return coded;
}

// Codes a positive number: 1, 2, 3, or the number of bits below its highest one, and these bits.
template <class Coder>
uint32_t RecordModel<Coder>::number(uint32_t context, uint32_t value) {
  constexpr uint32_t last = contexts::of_number - 1;
  uint32_t bits = 0;
  while (value >> bits > 3) ++bits;
  uint32_t size = bits == 0 ? value - 1 : bits + 2;
  size = symbol(context, size < last ? size : last);
  if (size < 3) return size + 1;
  bits = size == last ? raw_bits(5, bits) : size - 2;
  return uint32_t{2} << bits | raw_bits(bits + 1, value);
}

// With ample memory all records are regions; with little memory many are fragments.
template <class Coder>
RecordKind RecordModel<Coder>::record_kind(RecordKind kind) {
  kind = static_cast<RecordKind>(
      symbol(contexts::kinds + contexts::of_kinds * fragments_, static_cast<uint32_t>(kind)));
  chain_ = kind < RecordKind::forwards     ? ring
           : kind == RecordKind::backwards ? backwards
                                           : forwards;
  direction_ = no_direction;
  if (kind == RecordKind::backwards || kind == RecordKind::forwards)
    fragments_ = 2;
  else if (fragments_ > 1)
    fragments_ = 1;
  return kind;
}

// Chains are sent near the sweep: nearly all begin in the row of the vertex coded last or in the
// next row.
template <class Coder>
Vertex RecordModel<Coder>::start(const Vertex& start) {
  using namespace start_position;
  int32_t x = voxels_between(start.x, start_.x);
  int32_t y = voxels_between(start.y, start_.y);
  int32_t z = voxels_between(start.z, start_.z);
  uint32_t position = elsewhere;
  if (z == 0 && y == 0)
    position = x < 0 ? behind : static_cast<uint32_t>(x) < ahead ? static_cast<uint32_t>(x) : ahead;
  else if (z == 0 && y == 1)
    position = next_row;
  else if (z == 0 && y == -1)
    position = row_before;
  position = symbol(contexts::start_positions, position);
  if constexpr (!Coder::writes) {
    x = static_cast<int32_t>(position);
    y = position == next_row ? 1 : position == row_before ? -1 : 0;
    z = 0;
  }
  if (position >= ahead) {
    if (position == elsewhere) {
      z = signed_of(number(contexts::steps_z, positive_of(z)));
      y = signed_of(number(contexts::steps_y, positive_of(y)));
    }
    // The sign along the row follows from the position.
    const uint32_t coded = number(contexts::steps_x + contexts::of_number * (position - ahead),
                                  position == ahead    ? static_cast<uint32_t>(x) - ahead + 1
                                  : position == behind ? 0 - static_cast<uint32_t>(x)
                                                       : positive_of(x));
    if constexpr (!Coder::writes)
      x = position == ahead    ? static_cast<int32_t>(coded + ahead - 1)
          : position == behind ? static_cast<int32_t>(0 - coded)
                               : signed_of(coded);
  }
  const uint32_t axis =
      symbol(contexts::axes + (position == 0 ? 0 : 16) + 4U * axis_, axis_of(start));
  axis_before_ = axis_;
  axis_ = static_cast<uint8_t>(axis);
  is_same_voxel_ = position == 0;
  if constexpr (Coder::writes) return start_ = start;
  const uint32_t odd = axis == 3 ? 7 : 1U << axis;
  start_ = {voxels_beyond(start_.x, x, odd & 1), voxels_beyond(start_.y, y, odd >> 1 & 1),
            voxels_beyond(start_.z, z, odd >> 2)};
  return start_;
}

// Incidences point from on to off, so all edges at one voxel give the same sign along their axes:
// it is coded once. The other two components are predicted from the previous incidence; a negative
// sign mirrors them.
template <class Coder>
Incidence RecordModel<Coder>::incidence(Incidence incidence) {
  using contexts::other_heading;
  uint32_t code = other_heading;
  if (axis_ < 3) {
    const IncidenceOnAxis on_edge_axis = on_axis(incidence, axis_);
    uint32_t sign = 1;
    if (is_same_voxel_ && axis_before_ < 3) sign = on_axis(incidence_, axis_before_).along;
    if (sign == 1) sign = 2 * raw_bits(1, on_edge_axis.along >> 1);
    const auto mirrored_if_negative = [sign](uint32_t heading) {
      return sign == 0 ? 8 - heading : heading;
    };
    const uint32_t predicted_heading = mirrored_if_negative(on_axis(incidence_, axis_).heading);
    code = symbol(
        contexts::headings + contexts::of_headings * predicted_heading,
        on_edge_axis.along == sign ? mirrored_if_negative(on_edge_axis.heading) : other_heading);
    if constexpr (!Coder::writes)
      incidence = incidence_of({sign, mirrored_if_negative(code)}, axis_);
  }
  if (code == other_heading) incidence = static_cast<Incidence>(raw_bits(5, incidence));
  set_incidence(incidence);
  return incidence;
}

template <class Coder>
void RecordModel<Coder>::set_incidence(Incidence incidence) {
  if constexpr (!Coder::writes)
    if (!is_incidence(incidence)) return;
  incidence_ = incidence;
  incidence_class_ = static_cast<uint8_t>(class_of(incidence));
  class_contexts_ = static_cast<uint16_t>(incidence_class_ == 0   ? contexts::of_class(0)
                                          : incidence_class_ == 1 ? contexts::of_class(1)
                                                                  : contexts::of_class(2));
}

template <class Coder>
uint32_t RecordModel<Coder>::ring_direction(uint32_t from) {
  const uint32_t coded = class_symbol(contexts::ring_direction, from < 3 ? from : 3);
  return coded < 3 ? coded : raw_bits(3, from);
}

template <class Coder>
Direction RecordModel<Coder>::turn_by(uint32_t turn) {
  const uint32_t count = directions();
  const uint32_t next = direction_ + (is_backwards() ? count - turn : turn);
  return direction_ = static_cast<Direction>(next < count ? next : next - count);
}

// Codes the turn, and whether the run is longer than one link, as one symbol.
template <class Coder>
Run RecordModel<Coder>::run(Run run) {
  const uint32_t parity = incidence_class_ == 2 ? direction_ & 1 : 0;
  const uint32_t code = direction_symbol(
      contexts::turn + 2 * parity, 2 * turn_to(run.direction()) + (run.length() > 1 ? 1U : 0U));
  const Direction direction = turn_by(code >> 1);
  if (code % 2 == 0) return Run::straight(direction, 1);
  const uint32_t more = length(contexts::longer, direction, run.length() - 1);
  return more < Run::max_length ? Run::straight(direction, 1 + more) : Run();
}

template <class Coder>
bool RecordModel<Coder>::part(Record& record, bool begins_ring) {
  const uint32_t flags = raw_bits(4, (record.is_fragment ? 8U : 0U) | (record.continues ? 4U : 0U) |
                                         (record.is_last ? 2U : 0U) | (begins_ring ? 1U : 0U));
  record.incidence = static_cast<Incidence>(raw_bits(5, record.incidence));
  if constexpr (!Coder::writes) {
    record.is_fragment = (flags & 8) != 0;
    record.continues = (flags & 4) != 0;
    record.is_last = (flags & 2) != 0;
  }
  set_incidence(record.incidence);
  return (flags & 1) != 0;
}

}  // namespace discmc::detail::stream

#endif
