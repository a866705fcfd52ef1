#include "vertex_numbers.hpp"

#include "jobs/ordered_pipeline.hpp"

namespace discmc::meshing {

// Each job numbers a share of its own; then the shares are joined.
std::vector<std::uint32_t> VertexNumbers::add_all(const std::vector<Vertex>& positions,
                                                  unsigned jobs) {
  constexpr std::size_t min_share = 1 << 12;
  const std::size_t shares = std::clamp<std::size_t>(positions.size() / min_share, 1, jobs);
  std::vector<VertexNumbers> others(shares - 1);
  std::vector<std::uint32_t> numbers(positions.size());
  const auto for_each_of = [&](std::size_t share, auto call) {
    const std::size_t end = positions.size() * (share + 1) / shares;
    for (std::size_t i = positions.size() * share / shares; i < end; ++i) call(i);
  };
  // Three polygons or more meet in a corner. What is reserved and not used costs nothing.
  positions_.reserve(positions.size() / 3);
  run_in_any_order(jobs, shares, [&](std::size_t share) {
    VertexNumbers& own = share == 0 ? *this : others[share - 1];
    for_each_of(share, [&](std::size_t i) { numbers[i] = own.add(positions[i]); });
  });
  std::vector<std::vector<std::uint32_t>> numbers_here;
  numbers_here.reserve(others.size());
  for (VertexNumbers& other : others) numbers_here.push_back(join(std::move(other)));
  run_in_any_order(jobs, others.size(), [&](std::size_t other) {
    for_each_of(other + 1, [&](std::size_t i) { numbers[i] = numbers_here[other][numbers[i]]; });
  });
  return numbers;
}

// Polygons come by slices, so most tables are of one of the two alone, and what they hold need not
// be looked up.
std::vector<std::uint32_t> VertexNumbers::join(VertexNumbers&& other) {
  std::vector<bool> has_own(table_count);
  for (std::size_t i = 0; i < table_count; ++i) has_own[i] = !tables_[i].empty();
  std::vector<std::uint32_t> numbers_here;
  numbers_here.reserve(other.positions_.size());
  for (const Vertex& position : other.positions_) {
    if (has_own[table_of(position)]) {
      numbers_here.push_back(add(position));
    } else {
      numbers_here.push_back(static_cast<std::uint32_t>(positions_.size()));
      positions_.push_back(position);
    }
  }
  for (std::size_t i = 0; i < table_count; ++i) {
    if (has_own[i]) continue;
    tables_[i] = std::move(other.tables_[i]);
    tables_[i].renumber(numbers_here);
  }
  other = {};
  return numbers_here;
}

}  // namespace discmc::meshing
