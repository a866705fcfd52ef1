// Replaces the header in ports/mesh, because the module has no threads.
#pragma once

#include <cstddef>

namespace discmc::meshing {

template <class Item, class Fill, class Work, class Consume>
void run_in_order(unsigned, std::size_t count, Fill fill, Work work, Consume consume) {
  Item item{};
  for (std::size_t number = 0; number < count; ++number) {
    fill(number, item);
    work(number, item);
    consume(number, item);
  }
}

}  // namespace discmc::meshing
