#include "application_text.hpp"

#include <discmc/placement.hpp>

#include <cstdint>

namespace discmc::command {
namespace {

// Converts nanometres to millimetres without rounding: 1500000 is 1.5.
std::string millimetres(std::int64_t nanometres) {
  const bool is_negative = nanometres < 0;
  const auto bits = static_cast<std::uint64_t>(nanometres);
  const std::uint64_t size = is_negative ? 0 - bits : bits;
  std::string fraction = std::to_string(1000000 + size % 1000000);
  fraction[0] = '.';
  fraction.erase(fraction.find_last_not_of("0.") + 1);
  return (is_negative ? "-" : "") + std::to_string(size / 1000000) + fraction;
}

template <class Nanometres>
std::string vector_text(const Nanometres (&along)[3]) {
  return "(" + millimetres(along[0]) + ", " + millimetres(along[1]) + ", " + millimetres(along[2]) +
         ")";
}

const char* text(Space space) {
  constexpr const char* names[] = {"scanner space", "LPS", "RAS"};
  return names[static_cast<std::size_t>(space)];
}

std::string text(const Placement& placement) {
  return std::string("placement in ") + text(placement.space) + ", mm: origin " +
         vector_text(placement.origin_nm) + ", axes " + vector_text(placement.axes_nm[0]) + " " +
         vector_text(placement.axes_nm[1]) + " " + vector_text(placement.axes_nm[2]);
}

std::string text(const SlabRange& range) {
  return "slab of the slices " + std::to_string(range.first) + " to " +
         std::to_string(range.end() - 1) + " of " + std::to_string(range.depth);
}

std::string hexadecimal(const std::uint8_t* bytes, std::size_t count) {
  constexpr char digits[] = "0123456789abcdef";
  std::string text;
  for (std::size_t i = 0; i < count; ++i)
    text += {' ', digits[bytes[i] >> 4], digits[bytes[i] & 15]};
  return text;
}

}  // namespace

std::string text(const ApplicationRecord& record) {
  const std::string head = "kind " + std::to_string(record.kind) + ", slice " +
                           std::to_string(record.slice) + ", row " + std::to_string(record.row) +
                           ": ";
  Placement placement;
  if (read_placement(record, placement)) return head + text(placement);
  SlabRange range;
  if (read_slab_range(record, range)) return head + text(range);
  return head + std::to_string(record.count) + (record.count == 1 ? " byte" : " bytes") +
         hexadecimal(record.bytes, record.count);
}

}  // namespace discmc::command
