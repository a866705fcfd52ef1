// Encodes or decodes the fractions of a row after its voxels. A fraction is where the surface
// crosses an edge between two voxels, in eighths (fraction.hpp). Fractions are in the order of x. A
// voxel has up to three, in the order of the axes x, y and z.
//
// A receiver that lacks the slice before a key slice cannot find the edges along z that cross into
// it. So the fractions of these edges come last, after their number, and no other fraction depends
// on them.
#ifndef DISCMC_SLICES_FRACTION_CODE_HPP
#define DISCMC_SLICES_FRACTION_CODE_HPP

#include <discmc/slices/fractions.hpp>
#include <discmc/stream/wire.hpp>

namespace discmc::detail::slices {

/// The position in the fractions of a row. A coder is one of row_coders.hpp. The writer finds the
/// fractions in the entries of the row; the reader leaves them there.
class FractionCode {
 public:
  /// Whether the row's key slice has a slice before it, and whether that slice is known.
  enum class KeyEdges : uint8_t { none, known, unknown };

  /// off: whether the row is off. Limit: before reading, the entries of the row are 0.
  DISCMC_ALWAYS_INLINE void begin(const FractionRow& row, FractionModel& model, KeyEdges key_edges,
                                  const uint32_t* off) {
    row_ = row;
    model_ = &model;
    part_ = Part::edges;
    left_ = 0;
    last_ = 0;
    has_key_edges_ = key_edges != KeyEdges::none;
    are_key_edges_known_ = key_edges == KeyEdges::known;
    context_bits_ = FractionEntry::all;
    if (has_key_edges_) {
      context_bits_ = FractionEntry::along_x_and_y;
      has_key_fractions_ = are_key_edges_known_ && (row.crosses & 4) != 0;
      row_.crosses = row.crosses & 3;
      row_.slice_before = row_.both_before = off;
      key_below_ = row.slice_before;
    }
    begin_edges();
  }
  /// Ends a row that was skipped.
  void end() {
    part_ = Part::done;
    left_ = 0;
  }
  bool is_done() const { return part_ == Part::done; }
  /// The position of the next step: the part of the row, and what is left of it, as in a cut.
  uint32_t part() const {
    const auto part = static_cast<uint32_t>(part_);
    return detail::wire::row_part * (part_ == Part::edges ? part + axis() : part);
  }
  uint32_t left() const { return part_ == Part::edges ? row_.width - voxel() : left_; }

  /// Codes the next fraction, or the number of fractions that come last. Returns false if no
  /// encoder wrote the bits. Limit: not is_done(). Cost: 1 or 2 decisions; for a number, up to 16,
  /// and 15 raw bits.
  template <class Coder>
  DISCMC_ALWAYS_INLINE bool step(Coder& coder) {
    if (part_ == Part::count) return code_count(coder);
    if (part_ == Part::edges)
      code_edge(coder);
    else
      code_key_edge(coder);
    return true;
  }

 private:
  // The numbers are as in the tail of a cut packet (wire.hpp), in which 1 to 3 are the edges along
  // x, y and z.
  enum class Part : uint8_t { done = 0, edges = 1, count = 4, key_edges = 5 };
  static constexpr uint32_t eighths = 7;  // the bits of a fraction in an entry
  static constexpr int32_t none = INT32_MIN;

  void begin_edges() {
    word_ = UINT32_MAX;
    voxels_ = 0;
    find_voxel();
  }
  // Finds the next voxel with an edge.
  void find_voxel() {
    while (voxels_ == 0) {
      if (++word_ == row_.words) {
        part_ = Part::done;
        if (has_key_edges_) begin_key_edges();
        return;
      }
      if (!row_.is_level(word_)) voxels_ = row_.find(word_);
    }
    bit_ = static_cast<uint8_t>(trailing_zeros(voxels_));
    voxels_ &= voxels_ - 1;
    // See alike_.
    uint32_t alike = voxels_of(row_.here) | voxels_of(row_.row_before) << 3 |
                     voxels_of(row_.slice_before) << 6 | voxels_of(row_.both_before) << 9;
    is_on_ = (alike & 2) != 0;
    if (!is_on_) alike ^= 0xFFF;
    alike_ = static_cast<uint16_t>(alike);
    axes_ = row_.crosses & ~((alike & 1) | (alike >> 3 & 2) | (alike >> 5 & 4));
    if (voxel() == 0) axes_ &= ~uint32_t{1};
  }
  // The bits of a row from x - 1 to x + 1.
  DISCMC_ALWAYS_INLINE uint32_t voxels_of(const uint32_t* row) const {
    return row[word_] >> (bit_ - 1) & 7;
  }
  // Moves to the edges along z. In a row without such known edges, none is found.
  void begin_key_edges() {
    part_ = Part::count;
    has_key_edges_ = false;
    row_.crosses = has_key_fractions_ ? 4 : 0;
    row_.slice_before = key_below_;
    count_ = 0;
    for (uint32_t word = 0; word < row_.words; ++word)
      for (uint32_t edges = row_.find(word); edges != 0; edges &= edges - 1) ++count_;
  }
  void advance_edge() {
    axes_ &= axes_ - 1;
    if (axes_ == 0) find_voxel();
  }
  uint32_t voxel() const { return word_ * trace::columns_per_word + bit_ - 2; }
  uint32_t axis() const { return trailing_zeros(axes_); }

  template <class Coder>
  uint32_t code_fraction(Coder& coder, uint32_t context, uint32_t fraction) {
    const uint32_t bits = model_->bits();
    const uint32_t read = coder.tree(model_->tree(context), bits, fraction >> (3 - bits));
    return (2 * read + 1) << (2 - bits);
  }

  // Codes a fraction as seen from the end of the edge that is off.
  template <class Coder>
  DISCMC_ALWAYS_INLINE void code_edge(Coder& coder) {
    const uint32_t axis = this->axis();
    uint16_t& entry = row_.entries[voxel()];
    const uint32_t shift = 3 * axis;
    const uint32_t stored = entry >> shift & eighths;
    const uint32_t written = is_on_ ? stored : 8 - stored;
    const uint32_t read = code_fraction(coder, context_of(axis), written);
    const uint32_t fraction = is_on_ ? read : 8 - read;
    if (read != written) {  // a reader
      entry = static_cast<uint16_t>(entry | fraction << shift);
      *row_.has_fractions = true;
    }
    if (axis < 2) row_.queue->push(fraction);
    advance_edge();
  }

  // Returns the crossing of a parallel edge of the same cell. lower, upper: its ends, as bits of
  // alike_. If both ends are alike, returns half an edge beyond the end towards which it would
  // cross. Units: eighths from the lower end; or none.
  int32_t crossing_beside(uint32_t lower, uint32_t upper, uint32_t fraction) const {
    const bool is_alike = (alike_ >> upper & 1) != 0;
    if (((alike_ >> lower ^ alike_ >> upper) & 1) == 0) return is_alike ? -4 : 12;
    fraction &= eighths;
    return is_alike && fraction != 0 ? static_cast<int32_t>(fraction) : none;
  }
  // Returns the crossing of a plane through three other crossings. The third is opposite to this
  // edge.
  static int32_t crossing_in_plane(int32_t first, int32_t second, int32_t opposite) {
    if (first == none) return second;
    if (second == none) return first;
    return opposite == none ? (first + second) >> 1 : first + second - opposite;
  }
  // Converts a crossing to thirds from the end that is off.
  DISCMC_ALWAYS_INLINE uint32_t line_context(int32_t crossing) const {
    if (crossing == none) return 0;
    if (!is_on_) crossing = 8 - crossing;
    if (crossing < -1) return 1;
    return crossing > 9 ? 6 : 1 + (static_cast<uint32_t>(3 * (crossing + 4)) >> 3);
  }
  // Returns the mean distance of crossings from their common end, in thirds of the edge, or 0 for
  // none. fractions: four of them, counted towards that end.
  static uint32_t end_context(uint32_t fractions) {
    if (fractions == 0) return 0;
    constexpr uint32_t ones = 0x249;  // the low bit of each fraction
    const uint32_t is_crossed = (fractions | fractions >> 1 | fractions >> 2) & ones;
    const uint32_t count = (is_crossed * ones >> 9) & 7;
    const uint32_t sum =
        (fractions & 7) + (fractions >> 3 & 7) + (fractions >> 6 & 7) + (fractions >> 9);
    return 1U + (3 * sum <= 16 * count ? 1U : 0U) + (3 * sum <= 8 * count ? 1U : 0U);
  }
  // Returns a context from the voxels of the edge beside at x + 1. lower: as for crossing_beside().
  DISCMC_ALWAYS_INLINE uint32_t forward_context(uint32_t lower) const {
    const bool is_upper_alike = (alike_ >> 2 & 1) != 0;
    const bool is_lower_alike = (alike_ >> lower & 1) != 0;
    if (is_upper_alike != is_lower_alike) return is_upper_alike ? 2 : 0;
    return is_upper_alike == is_on_ ? 1 : 3;  // both on, or both off
  }

  DISCMC_ALWAYS_INLINE uint32_t context_of(uint32_t axis) const {
    const uint16_t* const entry = row_.entries + voxel();
    const uint16_t* const entry_before = row_.entries_before + voxel();
    const uint32_t here = entry[0] & context_bits_, left = entry[-1] & context_bits_;
    const uint32_t before = entry_before[0] & context_bits_;
    int32_t crossing;
    uint32_t lower, upper = 0, next = 0, forward = 0;
    if (axis == 0) {
      crossing = crossing_in_plane(crossing_beside(3, 4, before), crossing_beside(6, 7, here >> 9),
                                   crossing_beside(9, 10, before >> 9));
      lower = left & FractionEntry::own;
    } else if (axis == 1) {
      crossing =
          crossing_in_plane(crossing_beside(3, 0, left >> 3), crossing_beside(10, 7, here >> 12),
                            crossing_beside(9, 6, left >> 12));
      lower = before & FractionEntry::own;
      upper = here & eighths;
      next = entry_before[1];
      forward = forward_context(5);
    } else {
      crossing =
          crossing_in_plane(crossing_beside(6, 0, left >> 6), crossing_beside(10, 4, before >> 6),
                            crossing_beside(9, 3, (entry_before[-1] & context_bits_) >> 6));
      lower = here >> FractionEntry::slice_before_shift;
      upper = here & FractionEntry::along_x_and_y;
      next = entry[1] >> FractionEntry::slice_before_shift;
      forward = forward_context(8);
    }
    lower |= ((8 - (next & eighths)) & eighths) << 9;
    const uint32_t lower_end = end_context(lower), upper_end = end_context(upper);
    const uint32_t off_end = is_on_ ? lower_end : upper_end;
    const uint32_t on_end = is_on_ ? upper_end : lower_end;
    using namespace fraction_context;
    return ((line_context(crossing) * off_ends + off_end) * on_ends + on_end) * forwards + forward;
  }

  // Codes the width of the number, as ones and a zero, and then its bits below the highest.
  template <class Coder>
  DISCMC_ALWAYS_INLINE bool code_count(Coder& coder) {
    const uint32_t known_width = bit_width(count_);
    if (coder.tree(model_->width(left_), 1, left_ < known_width ? 1 : 0) != 0)
      return ++left_ < fraction_context::count_widths;
    if (left_ > 0) {
      const uint32_t top = uint32_t{1} << (left_ - 1);
      left_ = top | coder.raw_bits(left_ - 1, count_ & (top - 1));
    }
    if (left_ > row_.width || (are_key_edges_known_ && left_ != count_)) return false;
    part_ = left_ > 0 ? Part::key_edges : Part::done;
    if (left_ > 0 && are_key_edges_known_) begin_edges();
    return true;
  }

  template <class Coder>
  void code_key_edge(Coder& coder) {
    const uint32_t context = fraction_context::key_edge + (last_ + 1U) / 2;
    uint16_t& entry = row_.entries[are_key_edges_known_ ? voxel() : 0];
    last_ = static_cast<uint8_t>(code_fraction(coder, context, entry >> 6 & eighths));
    if (are_key_edges_known_) {
      *row_.has_fractions = true;
      entry = static_cast<uint16_t>((entry & ~(eighths << 6)) | static_cast<uint32_t>(last_) << 6);
      advance_edge();
    }
    if (--left_ == 0) part_ = Part::done;
  }

  FractionRow row_;
  FractionModel* model_ = nullptr;
  const uint32_t* key_below_ =
      nullptr;           // FractionRow::slice_before of edges along z into a key slice
  uint32_t voxels_ = 0;  // of the word, after the next edge's voxel
  uint32_t word_ = 0;
  uint32_t axes_ = 0;   // a bit per edge of this voxel that is not coded yet
  uint32_t left_ = 0;   // edges left along z into a key slice, or ones of their number so far
  uint32_t count_ = 0;  // number of these edges
  uint16_t context_bits_ = 0;  // bits of entries on which contexts depend
  // Voxels that equal this one, a bit each: x - 1, x and x + 1 of four rows. Bits 0 to 2 belong to
  // row_.here, 3 to 5 to row_.row_before, 6 to 8 to row_.slice_before, 9 to 11 to row_.both_before.
  uint16_t alike_ = 0;
  uint8_t bit_ = 0;   // index of the next edge's voxel
  uint8_t last_ = 0;  // previous fraction
  Part part_ = Part::done;
  bool is_on_ = false;  // whether this voxel is on
  bool has_key_edges_ = false;
  bool are_key_edges_known_ = false;
  bool has_key_fractions_ = false;
};

}  // namespace discmc::detail::slices

#endif
