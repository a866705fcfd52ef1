#include "replayed_input.hpp"

#include <cstddef>
#include <iostream>
#include <utility>

namespace discmc::command {

ReplayedInput::ReplayedInput(std::string head) : bytes_(std::move(head)), rest_(std::cin.rdbuf()) {
  setg(bytes_.data(), bytes_.data(), bytes_.data() + bytes_.size());
  std::cin.rdbuf(this);  // clears its state as well
}

ReplayedInput::~ReplayedInput() {
  std::cin.rdbuf(rest_);
}

ReplayedInput::int_type ReplayedInput::underflow() {
  constexpr std::size_t most = 65536;
  bytes_.resize(most);
  const std::streamsize got = rest_->sgetn(bytes_.data(), most);
  setg(bytes_.data(), bytes_.data(), bytes_.data() + got);
  return got > 0 ? traits_type::to_int_type(bytes_[0]) : traits_type::eof();
}

}  // namespace discmc::command
