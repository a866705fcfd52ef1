// Processes numbers in parallel, in any order.
#ifndef DISCMC_MESH_JOBS_PARALLEL_HPP
#define DISCMC_MESH_JOBS_PARALLEL_HPP

#include <algorithm>
#include <cstddef>

#include "jobs/ordered_pipeline.hpp"

namespace discmc::meshing {

/// Calls work(number) for 0 to count - 1, by as many threads as there are jobs, in any order.
template <class Work>
void for_each_in_parallel(unsigned jobs, std::size_t count, Work work) {
  struct Nothing {};
  const auto no_step = [](std::size_t, Nothing&) {};
  run_in_order<Nothing>(
      jobs, count, no_step, [&work](std::size_t number, Nothing&) { work(number); }, no_step);
}

/// The size of all ranges but the last, in the next function.
constexpr std::size_t parallel_range = std::size_t{1} << 14;

/// Likewise calls work(first, end) for ranges of numbers from 0 to count - 1.
template <class Work>
void for_each_range_in_parallel(unsigned jobs, std::size_t count, Work work) {
  const std::size_t ranges = (count + parallel_range - 1) / parallel_range;
  for_each_in_parallel(jobs, ranges, [&work, count](std::size_t range) {
    work(range * parallel_range, std::min(count, (range + 1) * parallel_range));
  });
}

}  // namespace discmc::meshing

#endif
