#include <array>
#include <utility>

#include "byte_source.hpp"
#include "text/words.hpp"
#include "volume_error.hpp"

namespace discmc::command {
namespace {

// Four characters encode three bytes; '=' fills the last four of a part. Parts
// may follow each other.
class Base64 final : public ByteSource {
 public:
  explicit Base64(std::unique_ptr<ByteSource> in) : in_(std::move(in)) {}

  std::size_t read(void* bytes, std::size_t count) override {
    auto* out = static_cast<unsigned char*>(bytes);
    std::size_t done = 0;
    while (done < count && (begin_ < end_ || next_four())) out[done++] = three_[begin_++];
    return done;
  }

  std::uint64_t max_left() const override {
    const std::uint64_t text = in_->max_left();
    const std::uint64_t in_memory = text_end_ - text_begin_ + end_ - begin_;
    return text > unbounded - in_memory ? unbounded : text + in_memory;
  }

  std::string damage() const override { return damage_.empty() ? in_->damage() : damage_; }

 private:
  // Returns the next character that is no blank, or '<' for the end.
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

  bool next_four() {
    std::uint32_t bits = 0;
    std::size_t filled = 0;
    begin_ = end_ = 0;
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
    end_ = 3 - filled;
    return true;
  }

  std::unique_ptr<ByteSource> in_;
  std::array<char, 65536> text_;
  std::size_t text_begin_ = 0;
  std::size_t text_end_ = 0;
  std::array<unsigned char, 3> three_{};
  std::size_t begin_ = 0;
  std::size_t end_ = 0;
  std::string damage_;
};

}  // namespace

std::unique_ptr<ByteSource> base64_decoded(std::unique_ptr<ByteSource> in) {
  return std::make_unique<Base64>(std::move(in));
}

}  // namespace discmc::command
