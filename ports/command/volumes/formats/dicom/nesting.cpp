#include "nesting.hpp"

#include <array>
#include <fstream>
#include <limits>
#include <vector>

namespace discmc::command {
namespace {

constexpr std::uint64_t unknown_end = std::numeric_limits<std::uint64_t>::max();

// The items that are open at a byte, by where they end.
class OpenItems {
 public:
  /// length: as the file has it.
  void start(std::uint64_t content, std::uint32_t length) {
    constexpr std::uint32_t undefined = 0xffffffff;
    ends_.push_back(length == undefined ? unknown_end : content + length);
  }
  void end() {
    if (!ends_.empty()) ends_.pop_back();
  }
  /// Closes those that end before a byte.
  void go_to(std::uint64_t at) {
    while (!ends_.empty() && ends_.back() <= at) ends_.pop_back();
  }
  std::size_t count() const { return ends_.size(); }

 private:
  std::vector<std::uint64_t> ends_;
};

// The last eight bytes of a file: a tag, and a length.
class Window {
 public:
  void add(std::uint8_t byte) { bytes_ = bytes_ << 8 | byte; }
  std::uint32_t tag() const { return static_cast<std::uint32_t>(bytes_ >> 32); }
  std::uint32_t big_endian_length() const { return static_cast<std::uint32_t>(bytes_); }
  std::uint32_t length() const {
    const std::uint32_t b = big_endian_length();
    return b >> 24 | (b >> 8 & 0xff00) | (b << 8 & 0xff0000) | b << 24;
  }

 private:
  std::uint64_t bytes_ = 0;
};

}  // namespace

bool is_nested_within(std::uint32_t most, const std::filesystem::path& file) {
  std::ifstream in(file, std::ios::binary);
  OpenItems items;
  Window window;
  std::uint64_t at = 0;
  std::array<char, 65536> block;
  while (in.read(block.data(), block.size()), in.gcount() > 0)
    for (std::streamsize i = 0; i < in.gcount(); ++i) {
      window.add(static_cast<std::uint8_t>(block[static_cast<std::size_t>(i)]));
      ++at;
      const std::uint32_t tag = window.tag();
      const bool is_item = tag == 0xfeff00e0;
      const bool is_big_endian_item = tag == 0xfffee000;
      if (tag == 0xfeff0de0 || tag == 0xfffee00d) items.end();
      if (!is_item && !is_big_endian_item) continue;
      items.go_to(at - 8);
      items.start(at, is_item ? window.length() : window.big_endian_length());
      if (items.count() > most) return false;
    }
  return true;
}

}  // namespace discmc::command
