#include "model.hpp"

#include <algorithm>

#include <discmc/stream/region_model.hpp>

namespace discmc::host::version1 {
namespace {

// The contexts, by what they tell.
constexpr std::uint32_t size_of_number = 8;
constexpr std::uint32_t size_of_delta = 2 + size_of_number;
constexpr std::uint32_t size_of_run_length = 7;
constexpr std::uint32_t size_of_tree = 7;  // of 3 bits

constexpr std::uint32_t even = 0;                                    // one or zero, equally likely
constexpr std::uint32_t region_follows_by_mark = even + 1;           // by: whether a mark came last
constexpr std::uint32_t kind_of_other = region_follows_by_mark + 2;  // tree
constexpr std::uint32_t component_zero = kind_of_other + size_of_tree;  // by row, before
constexpr std::uint32_t component_sign = component_zero + 15;           // likewise
constexpr std::uint32_t one_ring = component_sign + 18;                 // by class
constexpr std::uint32_t start_z = one_ring + 3;                         // by: mark came last, class
constexpr std::uint32_t start_y = start_z + 6 * size_of_delta;          // by z step
constexpr std::uint32_t start_x = start_y + 6 * size_of_delta;          // by same layer, y step
constexpr std::uint32_t start_hole = start_x + 10 * size_of_delta;      // z, y, x of a further ring
constexpr std::uint32_t first_direction = start_hole + 3 * size_of_delta;     // by incidence, tree
constexpr std::uint32_t parallelogram = first_direction + 27 * size_of_tree;  // by class
constexpr std::uint32_t run_count_by_class = parallelogram + 3;
constexpr std::uint32_t next_turn =
    run_count_by_class + 3 * size_of_number;                               // by class, turn, tree
constexpr std::uint32_t run_length = next_turn + 21 * size_of_tree;        // by kind, length
constexpr std::uint32_t item_kind = run_length + 16 * size_of_run_length;  // tree of 2 bits
constexpr std::uint32_t part_kind = item_kind + 3;      // fragment, continues, is last
constexpr std::uint32_t fragment_told = part_kind + 3;  // its number
constexpr std::uint32_t fragment_put_back = fragment_told + size_of_delta;  // likewise
constexpr std::uint32_t context_count = fragment_put_back + size_of_delta;

// Of a one, in 256ths.
// clang-format off
constexpr Probability probabilities[] = {
128, 235, 215, 1, 145, 128, 109, 1, 128, 128, 66, 128, 72, 47, 96, 43, 60, 135, 50, 24,
77, 35, 77, 148, 90, 227, 116, 26, 208, 121, 56, 215, 137, 49, 84, 137, 169, 65, 144, 185,
81, 149, 169, 255, 254, 252, 181, 188, 92, 8, 47, 101, 70, 128, 128, 128, 149, 125, 81, 9,
74, 74, 164, 55, 128, 128, 147, 68, 147, 6, 64, 48, 128, 98, 128, 128, 2, 1, 199, 156,
246, 252, 216, 167, 71, 9, 1, 1, 240, 150, 242, 253, 226, 155, 121, 5, 1, 3, 196, 170,
221, 236, 230, 161, 62, 14, 79, 17, 190, 144, 118, 64, 22, 37, 128, 128, 66, 16, 162, 86,
104, 67, 68, 48, 66, 128, 70, 76, 172, 95, 88, 71, 46, 27, 37, 128, 86, 170, 94, 119,
160, 190, 247, 204, 61, 7, 71, 123, 159, 115, 185, 230, 236, 204, 18, 14, 9, 40, 244, 239,
242, 250, 217, 152, 39, 6, 14, 126, 233, 226, 189, 149, 139, 139, 4, 128, 39, 4, 182, 180,
197, 168, 104, 7, 128, 128, 68, 8, 157, 192, 218, 216, 134, 149, 3, 128, 38, 41, 143, 139,
186, 148, 113, 14, 91, 128, 15, 155, 234, 238, 238, 219, 148, 62, 1, 128, 33, 26, 225, 233,
226, 227, 177, 140, 1, 128, 75, 13, 201, 219, 201, 166, 96, 1, 91, 128, 44, 24, 176, 221,
206, 189, 125, 49, 1, 128, 76, 56, 158, 189, 178, 158, 68, 2, 128, 128, 15, 199, 227, 232,
230, 205, 131, 58, 1, 128, 41, 242, 237, 141, 65, 74, 135, 39, 128, 128, 68, 157, 190, 119,
33, 103, 148, 63, 128, 128, 129, 145, 85, 38, 77, 182, 74, 128, 128, 128, 87, 78, 1, 23,
230, 115, 128, 1, 151, 128, 2, 253, 128, 128, 170, 4, 1, 81, 147, 209, 128, 1, 1, 128,
30, 176, 128, 128, 74, 37, 233, 158, 88, 10, 253, 1, 153, 128, 1, 253, 128, 128, 84, 2,
1, 47, 54, 248, 128, 1, 1, 128, 1, 128, 128, 128, 80, 4, 1, 55, 62, 251, 128, 1,
109, 128, 9, 255, 128, 128, 142, 4, 250, 69, 37, 131, 197, 1, 186, 128, 1, 252, 128, 128,
64, 28, 223, 127, 69, 19, 242, 128, 128, 128, 128, 128, 128, 128, 153, 5, 248, 73, 22, 159,
195, 1, 3, 128, 4, 237, 128, 128, 65, 32, 227, 118, 73, 18, 242, 1, 104, 128, 1, 252,
128, 128, 186, 3, 1, 58, 169, 176, 128, 1, 65, 128, 1, 252, 128, 128, 168, 6, 1, 55,
65, 201, 128, 1, 2, 128, 22, 205, 128, 128, 137, 11, 253, 106, 13, 152, 197, 1, 154, 128,
1, 251, 128, 128, 94, 6, 1, 55, 46, 249, 128, 1, 2, 128, 20, 151, 128, 128, 121, 57,
1, 194, 19, 197, 128, 162, 79, 120, 255, 255, 32, 131, 42, 7, 128, 128, 255, 151, 25, 94,
11, 80, 70, 128, 255, 120, 106, 119, 52, 14, 50, 128, 1, 11, 128, 255, 218, 128, 128, 22,
115, 128, 201, 190, 128, 128, 1, 65, 128, 255, 251, 128, 128, 2, 26, 128, 253, 221, 128, 128,
1, 17, 128, 255, 249, 128, 128, 8, 156, 1, 255, 1, 228, 128, 58, 128, 128, 176, 80, 128,
128, 43, 166, 1, 255, 1, 252, 128, 17, 99, 1, 255, 2, 241, 128, 12, 161, 67, 244, 7,
189, 128, 6, 143, 80, 249, 5, 128, 128, 51, 71, 1, 255, 1, 255, 128, 21, 147, 223, 255,
198, 59, 241, 101, 190, 163, 158, 100, 98, 189, 128, 127, 255, 255, 203, 31, 253, 69, 189, 234,
254, 137, 8, 228, 40, 119, 241, 255, 114, 28, 204, 28, 196, 203, 246, 114, 108, 181, 128, 205,
205, 158, 180, 98, 222, 58, 194, 252, 252, 175, 128, 205, 53, 42, 254, 255, 122, 109, 247, 110,
54, 43, 6, 128, 74, 128, 159, 44, 45, 2, 90, 128, 128, 119, 61, 40, 6, 63, 128, 128,
136, 13, 33, 19, 128, 128, 128, 130, 39, 59, 5, 48, 128, 128, 188, 42, 55, 11, 30, 128,
128, 215, 43, 52, 4, 37, 128, 128, 229, 24, 71, 3, 128, 128, 128, 237, 39, 65, 14, 25,
128, 128, 242, 77, 63, 4, 30, 128, 128, 244, 50, 59, 3, 128, 128, 128, 249, 21, 44, 8,
128, 128, 128, 72, 91, 33, 13, 182, 74, 128, 78, 62, 34, 27, 128, 128, 128, 92, 98, 49,
9, 26, 128, 128, 54, 57, 42, 18, 98, 128, 128, 58, 31, 177, 151, 1, 255, 1, 1, 106,
198, 202, 210, 224, 128, 143, 163, 22, 163, 215, 212, 212, 217, 227, 149, 129, 124,
};
// clang-format on
static_assert(sizeof(probabilities) == context_count, "every context has one");

}  // namespace

bool Model::bit(std::uint32_t context) {
  return range_.decode(probabilities[context]);
}

// Nodes are numbered from 1, those below a node by twice its number and one more.
std::uint32_t Model::tree(std::uint32_t first, std::uint32_t bits) {
  std::uint32_t node = 1;
  for (std::uint32_t i = 0; i < bits; ++i)
    node = 2 * node + (bit(first == even ? even : first + node - 1) ? 1 : 0);
  return node - (std::uint32_t{1} << bits);
}

std::uint32_t Model::number(std::uint32_t first, std::uint32_t contexts) {
  std::uint32_t bits = 0;
  while (bit(first + std::min(bits, contexts - 1)) && bits < 31) ++bits;
  return (std::uint32_t{1} << bits) - 1 + tree(even, bits);
}

std::int32_t Model::delta(std::uint32_t first) {
  if (bit(first)) return 0;
  const bool is_negative = bit(first + 1);
  const std::uint32_t size = number(first + 2, size_of_number);
  return static_cast<std::int32_t>(is_negative ? ~size : size + 1);
}

// ---- records ----

bool Model::region_follows() {
  return bit(region_follows_by_mark + (is_after_region_ ? 0 : 1));
}

OtherKind Model::other_kind() {
  return static_cast<OtherKind>(tree(kind_of_other, 3));
}

std::uint32_t Model::layer() {
  is_after_region_ = false;
  return slice_ += plain_number();
}

std::uint32_t Model::plain_number() {
  return number(even, 1);
}

std::uint32_t Model::plain_bits(std::uint32_t count, std::uint32_t) {
  return tree(even, count);
}

// ---- regions ----

// Component by component, z first, each guessed from the record before.
Incidence Model::incidence() {
  const Vertex normal_before = normal(incidence_);
  const std::int32_t before[] = {normal_before.z, normal_before.y, normal_before.x};
  constexpr std::uint32_t first_row[] = {0, 1, 3};  // by how many components are told
  std::uint32_t zeros = 0, code = 0;
  for (std::uint32_t told = 0; told < 3; ++told) {
    const std::uint32_t by =
        3 * (first_row[told] + zeros) + static_cast<std::uint32_t>(before[told] + 1);
    std::uint32_t digit = 1;
    if (zeros < 2 && bit(component_zero + by))
      ++zeros;
    else
      digit = bit(component_sign + by) ? 0 : 2;
    code = 3 * code + digit;
  }
  incidence_ = static_cast<Incidence>(code);
  link_class_ = direction_count(incidence_) / 2U - 2;
  return incidence_;
}

std::uint32_t Model::ring_count() {
  return bit(one_ring + link_class_) ? 1 : 2 + plain_number();
}

Vertex Model::start(bool further) {
  const auto step = [&](std::uint32_t first, std::uint32_t row, std::uint32_t hole_row) {
    return delta(further ? start_hole + hole_row * size_of_delta : first + row * size_of_delta);
  };
  const std::int32_t dz = step(start_z, link_class_ + (is_after_region_ ? 0 : 3), 0);
  const bool is_near = dz >= -2 && dz <= 2;
  const std::int32_t dy = step(start_y, is_near ? static_cast<std::uint32_t>(dz + 2) : 5, 1);
  const auto by_y = static_cast<std::uint32_t>(std::clamp(dy, -2, 2) + 2);
  const bool is_same_layer = dz >= -1 && dz <= 1;
  // The sum of the coordinates is odd, so of x only the half is told.
  const std::int32_t half = step(start_x, by_y + (is_same_layer ? 5 : 0), 2);
  start_.z = wrapped_sum(start_.z, dz);
  start_.y = wrapped_sum(start_.y, dy);
  const auto even_x = static_cast<std::uint32_t>(wrapped_sum(start_.x >> 1, half)) << 1;
  const auto parity = static_cast<std::uint32_t>(start_.y ^ start_.z ^ 1) & 1;
  start_.x = static_cast<std::int32_t>(even_x | parity);
  is_after_region_ = true;
  begin_chain(further);
  return start_;
}

void Model::begin_chain(bool further) {
  is_further_ = further;
  direction_ = no_direction;
  turns_ = 0;
  length_ = 0;
}

bool Model::is_parallelogram() {
  return bit(parallelogram + link_class_);
}

std::uint32_t Model::run_count() {
  return 2 + number(run_count_by_class + link_class_ * size_of_number, size_of_number);
}

Direction Model::direction() {
  if (direction_ == no_direction) {
    const std::uint32_t first =
        is_further_ ? even : first_direction + std::uint32_t{incidence_} * size_of_tree;
    direction_ = static_cast<Direction>(tree(first, 3));
    return direction_;
  }
  // A class has a tree for each turn and one for none: 5, 7 or 9.
  const std::uint32_t by = link_class_ * (link_class_ + 4) + turns_;
  const std::uint32_t turn = tree(next_turn + by * size_of_tree, 3);
  turns_ = turn + 1;
  const std::uint32_t sum = direction_ + turn;
  direction_ = static_cast<Direction>(sum < directions() ? sum : sum - directions());
  return direction_;
}

bool Model::is_parallel() const {
  return turns_ == 1 || turns_ == 1 + directions() / 2;
}

std::uint32_t Model::length() {
  const bool is_axis_link = link_class_ == 2 && direction_ % 2 == 0;
  const std::uint32_t by = 4 * (is_axis_link ? 3 : link_class_) + length_;
  const std::uint32_t told = 1 + number(run_length + by * size_of_run_length, size_of_run_length);
  length_ = std::min(told, std::uint32_t{3});
  return told;
}

// ---- parts ----

PartHead Model::part() {
  PartHead head{};
  head.is_fragment = bit(part_kind);
  head.continues = bit(part_kind + 1);
  if (head.is_fragment) head.number = fragment_number(fragment_told);
  head.incidence = incidence();
  begin_chain(true);
  return head;
}

Item Model::item() {
  return static_cast<Item>(tree(item_kind, 2));
}

std::uint32_t Model::stand_in() {
  return fragment_number(fragment_put_back);
}

// Relative to the last one told, of either kind.
std::uint32_t Model::fragment_number(std::uint32_t first) {
  return fragment_ += static_cast<std::uint32_t>(delta(first));
}

bool Model::is_last_part() {
  return bit(part_kind + 2);
}

}  // namespace discmc::host::version1
