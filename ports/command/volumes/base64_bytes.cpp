#include <array>
#include <utility>

#include "byte_source.hpp"
#include "text/words.hpp"
#include "volume_error.hpp"

namespace discmc::command {
namespace {

// Decodes base64: four characters encode three bytes, and '=' fills up the last four of a part.
// Parts may follow each other.
class Base64Bytes final : public PartwiseSource {
 public:
  explicit Base64Bytes(std::unique_ptr<ByteSource> in) : in_(std::move(in)) {}

  std::uint64_t max_left() const override {
    const std::uint64_t text = in_->max_left();
    const std::uint64_t in_memory = text_end_ - text_begin_ + left_in_part();
    return text > unbounded - in_memory ? unbounded : text + in_memory;
  }

  std::string damage() const override { return damage_.empty() ? in_->damage() : damage_; }

 private:
  // Returns the next character that is not a blank, or '<' at the end.
  char next_character() {
    while (true) {
      if (text_begin_ == text_end_) {
        text_begin_ = 0;
        text_end_ = in_->read(text_.data(), text_.size());
        if (text_end_ == 0) return '<';
      }
      const char c = text_[text_begin_];
      if (c == '<') return c;
      ++text_begin_;
      if (!trimmed({&c, 1}).empty()) return c;
    }
  }

  static unsigned value_of(char c) {
    constexpr std::string_view digits =
        "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    return static_cast<unsigned>(digits.find(c));
  }

  bool next_part() override {
    std::uint32_t bits = 0;
    std::size_t filled = 0;
    for (std::size_t i = 0; i < 4; ++i) {
      const char c = next_character();
      if (c == '<' && i == 0) return false;
      const unsigned value = c == '=' ? 0 : value_of(c);
      filled += c == '=' ? 1 : 0;
      if (value > 63 || filled > 2 || (c != '=' && filled > 0)) {
        damage_ = "the base64 text holds " + shown({&c, 1}) + ", which is not allowed there";
        return false;
      }
      bits = bits << 6 | value;
    }
    for (std::size_t i = 0; i < 3; ++i)
      three_[i] = static_cast<unsigned char>(bits >> (16 - 8 * i));
    set_part(three_.data(), 3 - filled);
    return true;
  }

  std::unique_ptr<ByteSource> in_;
  std::array<char, 65536> text_;
  std::size_t text_begin_ = 0;
  std::size_t text_end_ = 0;
  std::array<unsigned char, 3> three_{};
  std::string damage_;
};

}  // namespace

std::unique_ptr<ByteSource> base64_decoded(std::unique_ptr<ByteSource> in) {
  return std::make_unique<Base64Bytes>(std::move(in));
}

}  // namespace discmc::command
