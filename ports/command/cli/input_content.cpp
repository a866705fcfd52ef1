#include "input_content.hpp"

#include <cstddef>
#include <fstream>
#include <iostream>
#include <utility>

#include "volumes/byte_source.hpp"
#include "volumes/format_list.hpp"

namespace discmc::command {
namespace {

std::string head_of(std::istream& in) {
  std::string head(magic_bytes, '\0');
  in.read(head.data(), static_cast<std::streamsize>(head.size()));
  head.resize(static_cast<std::size_t>(in.gcount()));
  return head;
}

}  // namespace

bool begins_like_volume(const std::string& input, std::optional<ReplayedInput>& replayed) {
  if (input == "-") {
    const std::string head = head_of(std::cin);
    replayed.emplace(head);
    return is_volume_head(head);
  }
  if (is_read_once(input)) return false;
  std::ifstream file(input, std::ios::binary);
  return !file || is_volume_head(head_of(file));
}

ReplayedInput::ReplayedInput(std::string head) : bytes_(std::move(head)), rest_(std::cin.rdbuf()) {
  setg(bytes_.data(), bytes_.data(), bytes_.data() + bytes_.size());
  std::cin.rdbuf(this);  // also clears its state
}

ReplayedInput::~ReplayedInput() {
  std::cin.rdbuf(rest_);
}

ReplayedInput::int_type ReplayedInput::underflow() {
  constexpr std::size_t max_bytes = 65536;
  bytes_.resize(max_bytes);
  const std::streamsize got = rest_->sgetn(bytes_.data(), max_bytes);
  setg(bytes_.data(), bytes_.data(), bytes_.data() + got);
  return got > 0 ? traits_type::to_int_type(bytes_[0]) : traits_type::eof();
}

}  // namespace discmc::command
