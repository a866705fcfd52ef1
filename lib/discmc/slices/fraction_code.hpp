// Codes or reads the fractions of a row after its voxels. They are in the order of x; those of one
// voxel are along x, y and z.
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
  /// Whether the row is in a key slice that has a slice before it, and whether that slice is known.
  enum class KeyEdges : uint8_t { none, known, unknown };

  /// Limit: before reading, the entries of the row are 0.
  void begin(const FractionRow& row, FractionModel& model, KeyEdges key_edges) {
    row_ = row;
    model_ = &model;
    part_ = Part::edges;
    left_ = 0;
    last_ = 0;
    has_key_edges_ = key_edges != KeyEdges::none;
    knows_key_edges_ = key_edges == KeyEdges::known;
    row_.crosses[2] = row.crosses[2] && !has_key_edges_;
    known_ = has_key_edges_ ? FractionEntry::along_x_and_y : FractionEntry::all;
    key_crosses_ = row.crosses[2] && knows_key_edges_;
    begin_pass();
  }
  /// For a row that was skipped.
  void end() {
    part_ = Part::done;
    left_ = 0;
  }
  bool is_done() const { return part_ == Part::done; }
  /// Where the next step begins: the part of the row, and what is left of it, as in a cut.
  uint32_t part() const {
    const auto part = static_cast<uint32_t>(part_);
    return detail::wire::row_part * (part_ == Part::edges ? part + axis() : part);
  }
  uint32_t left() const { return part_ == Part::edges ? row_.width - voxel() : left_; }

  /// Codes the next fraction, or the number of those that come last. False if the bits that were
  /// read are from no encoder. Limit: not is_done(). Cost: 1 or 2 decisions; for a number, up to
  /// 16 and 15 even bits.
  template <class Coder>
  bool step(Coder& coder) {
    if (part_ == Part::count) return code_count(coder);
    if (part_ == Part::edges)
      code_edge(coder, axis());
    else
      code_key_edge(coder);
    return true;
  }

 private:
  // As in a cut.
  enum class Part : uint8_t { done = 0, edges = 1, count = 4, key_edges = 5 };
  static constexpr uint32_t eighths = 7;  // the bits of a fraction in an entry
  static constexpr int32_t none = INT32_MIN;

  // Distances: their sum, and their number above it.
  static constexpr uint32_t one_distance = 1 << 16;

  // Those from the voxel of these fractions, the upper end of their edges.
  static uint32_t distances(uint32_t fractions) {
    uint32_t all = 0;
    for (; fractions != 0; fractions >>= 3)
      if ((fractions & eighths) != 0) all += one_distance + 8 - (fractions & eighths);
    return all;
  }
  // The mean in thirds of the edge, or none.
  static uint32_t third(uint32_t all) {
    if (all == 0) return 0;
    const uint32_t count = all / one_distance, sum = all % one_distance;
    return 1U + (3 * sum >= 8 * count ? 1U : 0U) + (3 * sum >= 16 * count ? 1U : 0U);
  }

  uint32_t words() const { return detail::trace::row_words(row_.width); }
  void begin_pass() {
    word_ = 0;
    load();
    seek();
  }
  void load() {
    if (!row_.find(word_, crossing_)) crossing_[0] = crossing_[1] = crossing_[2] = 0;
  }
  // Finds the next edge, from the present word on.
  void seek() {
    while ((crossing_[0] | crossing_[1] | crossing_[2]) == 0) {
      if (++word_ == words()) {
        part_ = Part::done;
        if (has_key_edges_) begin_key_edges();
        return;
      }
      load();
    }
    bit_ = trailing_zeros(crossing_[0] | crossing_[1] | crossing_[2]);
  }
  // Turns to the edges along z. In a row that is not known to have one, none is found.
  void begin_key_edges() {
    part_ = Part::count;
    has_key_edges_ = false;
    row_.crosses[0] = row_.crosses[1] = false;
    row_.crosses[2] = key_crosses_;
    count_ = 0;
    for (word_ = 0; word_ < words(); ++word_) {
      load();
      for (uint32_t bits = crossing_[2]; bits != 0; bits &= bits - 1) ++count_;
    }
  }
  void pass(uint32_t axis) {
    crossing_[axis] &= crossing_[axis] - 1;
    seek();
  }
  uint32_t voxel() const { return word_ * detail::trace::columns_per_word + bit_ - 2; }
  uint32_t axis() const {
    return (crossing_[0] >> bit_ & 1) != 0 ? 0 : (crossing_[1] >> bit_ & 1) != 0 ? 1 : 2;
  }

  template <class Coder>
  uint32_t code_fraction(Coder& coder, uint32_t context, uint32_t fraction) {
    FractionProbability* const tree = model_->tree(context);
    const bool is_high = coder.code_bit(tree[0], fraction >= 4);
    if (model_->levels() == 2) return is_high ? 6 : 2;
    const bool low = coder.code_bit(tree[is_high ? 2 : 1], (fraction & 2) != 0);
    return (is_high ? 4U : 0U) + (low ? 2U : 0U) + 1;
  }

  // Codes a fraction as seen from the end of the edge that is off.
  template <class Coder>
  void code_edge(Coder& coder, uint32_t axis) {
    const bool is_on = (row_.here[word_] >> bit_ & 1) != 0;
    uint16_t& entry = row_.now[voxel()];
    const uint32_t place = 3 * axis;
    const uint32_t known = entry >> place & eighths;
    const uint32_t written = is_on ? known : 8 - known;
    const uint32_t read = code_fraction(coder, context_of(axis, is_on), written);
    if (read != written) {  // a reader
      entry = static_cast<uint16_t>(entry | (is_on ? read : 8 - read) << place);
      *row_.is_any = true;
    }
    if (axis < 2) row_.queue->put(is_on ? read : 8 - read);
    pass(axis);
  }

  // Three lines beside the edge, which are edges of the same cell. The third is opposite to it.
  // lower, upper: their voxels, see alike_bits(). entry: that of x, if odd that of x - 1; from 2 on
  // in the row before. place: of the fraction in the entry.
  struct Line {
    uint8_t lower, upper, entry, place;
  };
  // clang-format off
  static constexpr Line lines_beside[3][3] = {
      {{3, 4, 2, 0}, {6, 7, 0, 9}, {9, 10, 2, 9}},
      {{3, 0, 1, 3}, {10, 7, 0, 12}, {9, 6, 1, 12}},
      {{6, 0, 1, 6}, {10, 4, 2, 6}, {9, 3, 3, 6}}};
  // clang-format on

  // Which voxels equal the upper end of the edge. There are three of this row from x - 1 on, then
  // three of the row before, then both in the slice before.
  uint32_t alike_bits(bool is_on) const {
    const uint32_t shift = bit_ - 1;
    const uint32_t bits = (row_.here[word_] >> shift & 7) | (row_.behind[word_] >> shift & 7) << 3 |
                          (row_.below[word_] >> shift & 7) << 6 |
                          (row_.below_behind[word_] >> shift & 7) << 9;
    return is_on ? bits & known_ : (bits & known_) ^ 0xFFF;
  }

  // Where the surface crosses the edge if it is a plane through the three lines. Units: eighths
  // from the lower end; or none.
  static int32_t crossing_of_plane(const Line* lines, const uint32_t* entries, uint32_t alike) {
    int32_t at[3];
    for (uint32_t i = 0; i < 3; ++i) {
      const Line& line = lines[i];
      const uint32_t upper = alike >> line.upper & 1;
      const uint32_t fraction = entries[line.entry] >> line.place & eighths;
      if ((alike >> line.lower & 1) == upper)
        at[i] = upper != 0 ? -4 : 12;
      else
        at[i] = upper != 0 && fraction != 0 ? static_cast<int32_t>(fraction) : none;
    }
    if (at[0] == none) return at[1];
    if (at[1] == none) return at[0];
    return at[2] == none ? (at[0] + at[1]) >> 1 : at[0] + at[1] - at[2];
  }

  uint32_t context_of(uint32_t axis, bool is_on) const {
    const uint32_t alike = alike_bits(is_on);
    const uint16_t* const now = row_.now + voxel();
    const uint16_t* const before = row_.before + voxel();
    const uint32_t entries[] = {now[0] & known_, now[-1] & known_, before[0] & known_,
                                before[-1] & known_};
    int32_t plane = crossing_of_plane(lines_beside[axis], entries, alike);
    uint32_t line = 0;
    if (plane != none) {
      if (!is_on) plane = 8 - plane;
      line = plane < -1 ? 1 : plane > 9 ? 6 : 1 + (static_cast<uint32_t>(3 * (plane + 4)) >> 3);
    }
    uint32_t lower, upper = 0, forward = 0;
    if (axis == 0) {
      lower = distances(entries[1] & FractionEntry::own);
    } else {
      const bool is_y = axis == 1;
      upper = distances(entries[0] & (is_y ? eighths : FractionEntry::along_x_and_y));
      lower =
          distances(is_y ? entries[2] & FractionEntry::own : entries[0] >> FractionEntry::below);
      const uint32_t next = (is_y ? before[1] : now[1] >> FractionEntry::below) & eighths;
      if (next != 0) lower += one_distance + next;
      // The line at x + 1, by its voxels alone.
      const uint32_t ends = (alike >> (is_y ? 5 : 8) & 1) + 2 * (alike >> 2 & 1);
      forward = ends == 3 ? 1 : ends == 2 ? 2 : ends == 0 ? 3 : 0;
      if (!is_on && forward % 2 != 0) forward = 4 - forward;
    }
    const uint32_t off_end = third(is_on ? lower : upper);
    const uint32_t on_end = third(is_on ? upper : lower);
    using namespace fraction_context;
    return ((line * off_ends + off_end) * on_ends + on_end) * forwards + forward;
  }

  // Codes a one or the zero of the width of the number, and after the zero its bits below the
  // highest.
  template <class Coder>
  bool code_count(Coder& coder) {
    const uint32_t known_width = bit_width(count_);
    if (coder.code_bit(model_->width(left_), left_ < known_width))
      return ++left_ < fraction_context::count_widths;
    if (left_ > 0) {
      const uint32_t top = uint32_t{1} << (left_ - 1);
      left_ = top | coder.number(left_ - 1, count_ & (top - 1));
    }
    if (left_ > row_.width || (knows_key_edges_ && left_ != count_)) return false;
    part_ = left_ > 0 ? Part::key_edges : Part::done;
    if (left_ > 0 && knows_key_edges_) begin_pass();
    return true;
  }

  template <class Coder>
  void code_key_edge(Coder& coder) {
    const uint32_t context = fraction_context::key_edge + (last_ + 1) / 2;
    if (knows_key_edges_) {
      uint16_t& entry = row_.now[voxel()];
      last_ = code_fraction(coder, context, entry >> 6 & eighths);
      *row_.is_any = true;
      entry = static_cast<uint16_t>((entry & ~(eighths << 6)) | last_ << 6);
      pass(2);
    } else {
      last_ = code_fraction(coder, context, 0);
    }
    if (--left_ == 0) part_ = Part::done;
  }

  FractionRow row_;
  FractionModel* model_ = nullptr;
  uint32_t crossing_[3] = {};  // of the word, those that are not coded yet
  uint32_t word_ = 0;
  uint32_t bit_ = 0;    // of the next edge
  uint32_t left_ = 0;   // edges along z into a key slice; before their number, its ones so far
  uint32_t count_ = 0;  // their number
  uint32_t known_ = 0;  // the bits of entries, and of voxels, on which contexts depend
  uint32_t last_ = 0;   // the fraction of the one before
  Part part_ = Part::done;
  bool has_key_edges_ = false;
  bool knows_key_edges_ = false;
  bool key_crosses_ = false;
};

}  // namespace discmc::detail::slices

#endif
