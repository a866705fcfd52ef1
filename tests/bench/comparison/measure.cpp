#include "measure.hpp"

#include <algorithm>
#include <ctime>

namespace discmc::bench {

namespace {

// Processor time, which depends less on other programs than wall time.
double nanoseconds_now() {
  return static_cast<double>(std::clock()) * (1e9 / static_cast<double>(CLOCKS_PER_SEC));
}

double median(std::vector<double> values) {
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

}  // namespace

std::vector<Result> measure(const std::vector<Contender>& contenders) {
  std::vector<Result> results;
  for (const Contender& contender : contenders)
    results.push_back({contender.name, contender.unit, contender.run(), 0});

  std::vector<std::vector<double>> times(contenders.size());
  const double begin = nanoseconds_now();
  for (int round = 0; round < 5 || (round < 25 && nanoseconds_now() - begin < 1e9); ++round)
    for (size_t i = 0; i < contenders.size(); ++i) {
      const double start = nanoseconds_now();
      contenders[i].run();
      times[i].push_back(nanoseconds_now() - start);
    }
  for (size_t i = 0; i < results.size(); ++i) results[i].nanoseconds = median(times[i]);
  return results;
}

}  // namespace discmc::bench
