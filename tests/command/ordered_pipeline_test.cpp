// Sequential steps, with parallel work between them.
#include "jobs/ordered_pipeline.hpp"

#include <atomic>
#include <stdexcept>
#include <thread>

#include "test.hpp"

namespace {

using discmc::meshing::run_in_order;

constexpr std::size_t count = 100;

std::vector<std::size_t> numbers_below(std::size_t end) {
  std::vector<std::size_t> numbers;
  for (std::size_t i = 0; i < end; ++i) numbers.push_back(i);
  return numbers;
}

}  // namespace

TEST_CASE("an ordered pipeline fills and consumes items in order with any number of threads") {
  for (const unsigned jobs : {1U, 2U, 7U}) {
    CAPTURE(jobs);
    std::vector<std::size_t> filled, consumed, results;
    run_in_order<std::size_t>(
        jobs, count,
        [&](std::size_t number, std::size_t& item) {
          filled.push_back(number);
          item = 3 * number;
        },
        [](std::size_t number, std::size_t& item) {
          if (number % 5 == 0) std::this_thread::yield();
          item += number;
        },
        [&](std::size_t number, std::size_t& item) {
          consumed.push_back(number);
          results.push_back(item / 4);
        });
    CHECK(filled == numbers_below(count));
    CHECK(consumed == numbers_below(count));
    CHECK(results == numbers_below(count));
  }
}

TEST_CASE("an ordered pipeline holds at most twice as many items as jobs") {
  for (const unsigned jobs : {1U, 3U}) {
    std::atomic<unsigned> held{0}, most{0};
    run_in_order<int>(
        jobs, count,
        [&](std::size_t, int&) {
          if (++held > most) most = held.load();
        },
        [](std::size_t, int&) {}, [&](std::size_t, int&) { --held; });
    CHECK(held == 0);
    CHECK(most <= 2 * jobs);
  }
}

TEST_CASE("an ordered pipeline with a single job runs in the calling thread") {
  const auto own = std::this_thread::get_id();
  run_in_order<int>(
      1, 3, [](std::size_t, int&) {},
      [own](std::size_t, int&) { CHECK((std::this_thread::get_id() == own)); },
      [](std::size_t, int&) {});
}

TEST_CASE("an ordered pipeline rethrows an exception of a step and drops later items") {
  for (const unsigned jobs : {1U, 4U})
    for (const std::string step : {"fill", "work", "take"}) {
      CAPTURE(step);
      std::size_t consumed = 0;
      const auto fail_in = [&step](const std::string& own, std::size_t number) {
        if (own == step && number == 20) throw std::runtime_error(own);
      };
      CHECK_THROWS_WITH_AS(
          run_in_order<int>(
              jobs, count, [&](std::size_t number, int&) { fail_in("fill", number); },
              [&](std::size_t number, int&) { fail_in("work", number); },
              [&](std::size_t number, int&) {
                fail_in("take", number);
                ++consumed;
              }),
          step.c_str(), std::runtime_error);
      CHECK(consumed <= 20);
    }
}

TEST_CASE("an ordered pipeline without items calls no step") {
  const auto never = [](std::size_t, int&) { FAIL("called"); };
  run_in_order<int>(2, 0, never, never, never);
}
