// MeshOptions::progress: its calls, and cancellation.
#include <thread>

#include "sampled_shapes.hpp"
#include "test.hpp"

using namespace discmc;
using namespace mesh_tests;

TEST_CASE("progress counts slices in order, then names the later steps") {
  const auto array = ball<float>();
  for (const unsigned threads : {1U, 3U}) {
    std::vector<std::string> steps;
    std::uint64_t last = 0;
    MeshOptions options;
    options.threads = threads;
    options.normals = Normals::gradient;
    const std::thread::id caller = std::this_thread::get_id();
    options.progress = [&](const MeshProgress& at) {
      CHECK((std::this_thread::get_id() == caller));
      if (steps.empty() || steps.back() != at.step) {
        steps.push_back(at.step);
        last = 0;
      }
      CHECK(at.done >= last);
      last = at.done;
      if (steps.back() == "extracting") CHECK(at.all == 24);
      CHECK((at.all == 0 || at.done <= at.all));
      return true;
    };
    (void)mesh_of(array.view(), ball_level, options);
    if (threads == 1) CHECK(steps.front() == "extracting");
    REQUIRE(steps.size() >= 2);
    CHECK(steps[steps.size() - 2] == "triangulating");
    CHECK(steps.back() == "normals");
    CHECK(last == 24);
  }
}

TEST_CASE(
    "a progress callback that returns false cancels at any call, with any number of threads") {
  const auto array = ball<float>();
  for (const unsigned threads : {1U, 4U})
    for (int calls = 1;; ++calls) {
      int left = calls;
      MeshOptions options;
      options.threads = threads;
      options.normals = Normals::surface;
      options.progress = [&](const MeshProgress&) { return --left > 0; };
      try {
        (void)mesh_of(array.view(), ball_level, options);
        CHECK(calls > (threads == 1 ? 20 : 2));
        break;
      } catch (const Cancelled&) {
        CHECK(left == 0);
      }
    }
}

TEST_CASE("exceptions thrown by a progress callback reach the caller unchanged") {
  struct Mine {};
  MeshOptions options;
  options.progress = [](const MeshProgress&) -> bool { throw Mine{}; };
  CHECK_THROWS_AS((void)mesh_of(std::vector<int>(27), {3, 3, 3}, 1, options), Mine);
  options.threads = 2;
  CHECK_THROWS_AS((void)mesh_of(std::vector<int>(27), {3, 3, 3}, 1, options), Mine);
  CHECK_THROWS_AS((void)label_meshes({std::vector<int>(27, 1), {3, 3, 3}}, options), Mine);
}

TEST_CASE("progress of label extraction counts the swept slices, in any order of axes") {
  const std::vector<std::uint8_t> labels(2 * 3 * 7, 1);
  MeshOptions options;
  std::uint64_t last = 0;
  options.progress = [&](const MeshProgress& at) {
    if (std::string(at.step) != "extracting") return true;
    CHECK(at.all == 7);
    last = at.done;
    return true;
  };
  (void)label_meshes({labels.data(), {7, 3, 2}, {6, 2, 1}}, options);
  CHECK(last == 7);
}
