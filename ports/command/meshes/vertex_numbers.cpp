#include "vertex_numbers.hpp"

#include "ordered_pipeline.hpp"

namespace discmc::host {

// Each job has tables of its own. What it has for numbers at first are the places where positions
// come first, which no other job has to know.
std::vector<std::uint32_t> VertexNumbers::add_all(const std::vector<Vertex>& positions,
                                                  unsigned jobs) {
  std::vector<std::uint32_t> numbers(positions.size());
  // Three polygons or more meet in a corner. What is reserved and not used costs nothing.
  positions_.reserve(positions.size() / 3);
  if (jobs == 1) {
    std::transform(positions.begin(), positions.end(), numbers.begin(),
                   [this](const Vertex& position) { return add(position); });
    return numbers;
  }
  constexpr unsigned most_shares = 16;  // each goes through all positions
  const unsigned shares = std::min(jobs, most_shares);
  std::vector<std::size_t> share_of(table_count);
  for (std::size_t table = 0; table < table_count; ++table) share_of[table] = table % shares;
  run_in_any_order(jobs, shares, [&](std::size_t share) {
    for (std::size_t i = 0; i < positions.size(); ++i) {
      const std::size_t table = table_of(positions[i]);
      if (share_of[table] == share)
        numbers[i] = tables_[table].add(positions[i], static_cast<std::uint32_t>(i), positions);
    }
  });
  for (std::size_t i = 0; i < numbers.size(); ++i) {
    const bool is_first = numbers[i] == i;
    numbers[i] = is_first ? static_cast<std::uint32_t>(positions_.size()) : numbers[numbers[i]];
    if (is_first) positions_.push_back(positions[i]);
  }
  run_in_any_order(jobs, table_count, [&](std::size_t table) { tables_[table].renumber(numbers); });
  return numbers;
}

}  // namespace discmc::host
