// The values of labels: whole numbers of up to 64 bits.
#ifndef DISCMC_MESH_SAMPLES_LABEL_VALUE_HPP
#define DISCMC_MESH_SAMPLES_LABEL_VALUE_HPP

#include <cstdint>
#include <string>
#include <type_traits>

namespace discmc::meshing {

/// The exact value of a sample of any whole-number type. double would round values above 2^53, such
/// as ids in connectomics.
class LabelValue {
 public:
  constexpr LabelValue() = default;
  template <class Whole, class = std::enable_if_t<std::is_integral_v<Whole>>>
  constexpr LabelValue(Whole value) : bits_(static_cast<std::uint64_t>(value)) {
    if constexpr (std::is_signed_v<Whole>) is_negative_ = value < 0;
  }

  constexpr bool operator==(LabelValue other) const {
    return bits_ == other.bits_ && is_negative_ == other.is_negative_;
  }
  constexpr bool operator!=(LabelValue other) const { return !(*this == other); }
  constexpr bool operator<(LabelValue other) const {
    return is_negative_ == other.is_negative_ ? bits_ < other.bits_ : is_negative_;
  }

  constexpr std::uint64_t bits() const { return bits_; }
  std::string text() const {
    return is_negative_ ? std::to_string(static_cast<std::int64_t>(bits_)) : std::to_string(bits_);
  }
  /// Returns the value, rounded if it needs more than 53 bits.
  constexpr double rounded() const {
    return is_negative_ ? static_cast<double>(static_cast<std::int64_t>(bits_))
                        : static_cast<double>(bits_);
  }
  constexpr bool is_rounded() const {
    std::uint64_t digits = is_negative_ ? ~bits_ + 1 : bits_;
    while (digits % 2 == 0 && digits != 0) digits /= 2;
    return digits >> 53 != 0;
  }

 private:
  std::uint64_t bits_ = 0;  // in two's complement
  bool is_negative_ = false;
};

}  // namespace discmc::meshing

#endif
