// A piece of the caller's memory.
#ifndef DISCMC_MEMORY_HPP
#define DISCMC_MEMORY_HPP

#include <stddef.h>

namespace discmc {

/// A piece of memory. Owner: the caller.
struct Memory {
  void* data = nullptr;
  size_t bytes = 0;
};

/// The memory of an array of bytes, words or plain structs. Owner: the caller.
template <class Item, size_t N>
constexpr Memory memory_of(Item (&array)[N]) {
  return {array, sizeof array};
}
/// The memory of a std::array, std::span or std::vector, as long as it keeps its size.
template <class Items>
constexpr auto memory_of(Items& items) -> decltype(Memory{items.data(), items.size()}) {
  return {items.data(), items.size() * sizeof *items.data()};
}

}  // namespace discmc

#endif
