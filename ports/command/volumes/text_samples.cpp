#include <array>
#include <cstring>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>

#include "byte_source.hpp"
#include "text/number_text.hpp"
#include "text/words.hpp"
#include "volume_error.hpp"

namespace discmc::command {
namespace {

class TextSamples final : public PartwiseSource {
 public:
  TextSamples(std::unique_ptr<ByteSource> in, SampleType type) : in_(std::move(in)), type_(type) {}

  // A number needs at least a character and a blank.
  std::uint64_t max_left() const override {
    const std::uint64_t text = in_->max_left();
    const std::uint64_t in_memory = (text_end_ - text_begin_ + left_in_part()) + 1;
    if (text >= unbounded / sample_.size() - in_memory) return unbounded;
    return (text + in_memory) * sample_.size();
  }

  std::string damage() const override { return damage_.empty() ? in_->damage() : damage_; }

 private:
  // Returns the next character without consuming it, or '<' at the end.
  char peek_character() {
    if (text_begin_ == text_end_) {
      text_begin_ = 0;
      text_end_ = in_->read(text_.data(), text_.size());
    }
    return text_begin_ < text_end_ ? text_[text_begin_] : '<';
  }

  static bool is_between(char c) { return c == ',' || trimmed({&c, 1}).empty(); }

  bool next_part() override {
    if (!damage_.empty()) return false;
    while (is_between(peek_character())) ++text_begin_;
    constexpr std::size_t max_characters = 400;  // more than the digits of the largest double
    word_.clear();
    for (char c = peek_character(); c != '<' && !is_between(c); c = peek_character()) {
      if (word_.size() < max_characters) word_ += c;
      ++text_begin_;
    }
    if (word_.empty()) return false;
    const bool is_number = with_sample_type(type_, [this](auto sample) {
      const bool is_read = parse(sample);
      std::memcpy(sample_.data(), &sample, sizeof sample);
      return is_read;
    });
    set_part(sample_.data(), is_number ? sample_bytes(type_) : 0);
    if (is_number) return true;
    damage_ = "the text " + shown(word_) + " is not a sample of type " + std::string(name(type_));
    return false;
  }

  template <class Sample>
  bool parse(Sample& sample) {
    const auto value = [this] {
      if constexpr (std::is_floating_point_v<Sample>)
        return decimal_number(word_);
      else
        return whole_number<Sample>(std::string_view(word_).substr(word_[0] == '+' ? 1 : 0));
    }();
    sample = static_cast<Sample>(value.value_or(0));
    return value.has_value();
  }

  std::unique_ptr<ByteSource> in_;
  SampleType type_;
  std::array<char, 65536> text_;
  std::size_t text_begin_ = 0;
  std::size_t text_end_ = 0;
  std::array<unsigned char, 8> sample_{};
  std::string word_;
  std::string damage_;
};

}  // namespace

std::unique_ptr<ByteSource> samples_of_text(std::unique_ptr<ByteSource> in, SampleType type) {
  return std::make_unique<TextSamples>(std::move(in), type);
}

}  // namespace discmc::command
