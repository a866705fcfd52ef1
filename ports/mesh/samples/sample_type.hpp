// The types of samples, and dispatch by type.
#ifndef DISCMC_MESH_SAMPLES_SAMPLE_TYPE_HPP
#define DISCMC_MESH_SAMPLES_SAMPLE_TYPE_HPP

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string_view>
#include <type_traits>
#include <utility>

namespace discmc::meshing {

/// Unsigned and signed whole numbers, and IEEE 754 floating point, with their bits.
enum class SampleType : std::uint8_t { u8, i8, u16, i16, u32, i32, u64, i64, f32, f64 };

/// All types with their names on the command line.
constexpr std::pair<std::string_view, SampleType> sample_types[] = {
    {"u8", SampleType::u8},   {"i8", SampleType::i8},   {"u16", SampleType::u16},
    {"i16", SampleType::i16}, {"u32", SampleType::u32}, {"i32", SampleType::i32},
    {"u64", SampleType::u64}, {"i64", SampleType::i64}, {"f32", SampleType::f32},
    {"f64", SampleType::f64}};

constexpr std::string_view name(SampleType type) {
  return sample_types[static_cast<std::size_t>(type)].first;
}

constexpr std::optional<SampleType> sample_type_called(std::string_view text) {
  for (const auto& [called, type] : sample_types)
    if (called == text) return type;
  return std::nullopt;
}

/// Returns call(Sample{}) with the C++ type of the samples.
template <class Call>
decltype(auto) with_sample_type(SampleType type, Call&& call) {
  switch (type) {
    case SampleType::u8:
      return call(std::uint8_t{});
    case SampleType::i8:
      return call(std::int8_t{});
    case SampleType::u16:
      return call(std::uint16_t{});
    case SampleType::i16:
      return call(std::int16_t{});
    case SampleType::u32:
      return call(std::uint32_t{});
    case SampleType::i32:
      return call(std::int32_t{});
    case SampleType::u64:
      return call(std::uint64_t{});
    case SampleType::i64:
      return call(std::int64_t{});
    case SampleType::f32:
      return call(float{});
    case SampleType::f64:
      break;
  }
  return call(double{});
}

constexpr bool is_floating(SampleType type) {
  return type == SampleType::f32 || type == SampleType::f64;
}

/// Likewise dispatches only whole-number types. Limit: not is_floating(type).
template <class Call>
void with_whole_type(SampleType type, Call&& call) {
  with_sample_type(type, [&](auto typed) {
    if constexpr (std::is_integral_v<decltype(typed)>) call(typed);
  });
}

/// Whether the library accepts such samples directly: the extractor, and gradients.
constexpr bool is_scanner_type(SampleType type) {
  return type == SampleType::u8 || type == SampleType::u16 || type == SampleType::i16;
}

/// Likewise dispatches only these types. Limit: is_scanner_type(type).
template <class Call>
decltype(auto) with_scanner_type(SampleType type, Call&& call) {
  if (type == SampleType::u8) return call(std::uint8_t{});
  if (type == SampleType::u16) return call(std::uint16_t{});
  return call(std::int16_t{});
}

/// Returns the size of a sample. Units: bytes.
constexpr std::size_t sample_bytes(SampleType type) {
  switch (type) {
    case SampleType::u8:
    case SampleType::i8:
      return 1;
    case SampleType::u16:
    case SampleType::i16:
      return 2;
    case SampleType::u32:
    case SampleType::i32:
    case SampleType::f32:
      return 4;
    case SampleType::u64:
    case SampleType::i64:
    case SampleType::f64:
      break;
  }
  return 8;
}

}  // namespace discmc::meshing

#endif
