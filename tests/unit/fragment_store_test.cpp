// Fragments over one pool of runs, and vectors of links to compare with.
#include <doctest/doctest.h>
#include <discmc/fragment_store.hpp>

#include <vector>

using namespace discmc;

namespace {

template <class Index>
class Store : public FragmentStore<Index> {
 public:
  explicit Store(uint32_t capacity) : nodes_(capacity) {
    this->start(nodes_.data(), capacity);
    this->clear();
  }

 private:
  std::vector<RunNode<Index>> nodes_;
};

template <class Index>
Fragment<Index> empty_fragment() {
  Fragment<Index> fragment{};
  fragment.clear();
  return fragment;
}

template <class Index>
std::vector<Run> runs_of(const Store<Index>& store, const Fragment<Index>& fragment) {
  std::vector<Run> runs;
  for (Index node = store.first(fragment); node != no_record; node = store.after(fragment, node))
    runs.push_back(store.run(node));
  if (!fragment.is_empty()) runs.push_back(fragment.tail);
  return runs;
}

// No two neighbours of one direction: these stay runs of their own.
Run run_number(uint32_t i) {
  return Run::straight(static_cast<Direction>(i % 8), 1 + i % 1000);
}

template <class Index>
Fragment<Index> fragment_of(Store<Index>& store, uint32_t first, uint32_t count) {
  Fragment<Index> fragment = empty_fragment<Index>();
  for (uint32_t i = 0; i < count; ++i) store.append(fragment, run_number(first + i));
  return fragment;
}

std::vector<Run> runs_from(uint32_t first, uint32_t count) {
  std::vector<Run> runs;
  for (uint32_t i = 0; i < count; ++i) runs.push_back(run_number(first + i));
  return runs;
}

}  // namespace

TEST_CASE("runs come back in the order in which they were appended, the last in place") {
  Store<uint16_t> store(10);
  for (uint32_t count = 0; count <= 10; ++count) {
    Fragment<uint16_t> fragment = fragment_of(store, 3, count);
    CHECK(runs_of(store, fragment) == runs_from(3, count));
    CHECK(store.in_use() == (count > 0 ? count - 1 : 0));
    store.give_nodes(fragment);
    CHECK(store.in_use() == 0);
    CHECK(runs_of(store, fragment) == runs_from(3 + count - (count > 0), count > 0));
  }
}

TEST_CASE("links of one direction are one run") {
  Store<uint32_t> store(2);
  Fragment<uint32_t> fragment = empty_fragment<uint32_t>();
  for (int i = 0; i < 50; ++i) store.append(fragment, Run::straight(2, 1));
  CHECK(runs_of(store, fragment) == std::vector<Run>{Run::straight(2, 50)});
  CHECK(store.in_use() == 0);
}

TEST_CASE("joined fragments are one behind the other, of any lengths, and take one node at most") {
  for (uint32_t a = 0; a < 5; ++a)
    for (uint32_t b = 0; b < 5; ++b)
      for (uint32_t c = 0; c < 3; ++c) {
        Store<uint16_t> store(12);
        Fragment<uint16_t> fragment = fragment_of(store, 0, a);
        const uint32_t before = store.in_use();
        const Fragment<uint16_t> second = fragment_of(store, a, b);
        const uint32_t taken = store.in_use();
        store.join(fragment, second);
        CHECK(store.in_use() == taken + (a > 0 && b > 0));
        CHECK(before <= taken);
        store.join(fragment, fragment_of(store, a + b, c));
        CHECK(runs_of(store, fragment) == runs_from(0, a + b + c));
        store.give_nodes(fragment);
        CHECK(store.in_use() == 0);
      }
}

TEST_CASE("where a join meets one direction the two runs become one, without a node") {
  for (uint32_t more = 0; more < 3; ++more) {
    Store<uint16_t> store(8);
    Fragment<uint16_t> fragment = fragment_of(store, 0, 3);
    Fragment<uint16_t> other = empty_fragment<uint16_t>();
    store.append(other, Run::straight(2, 7));
    for (uint32_t i = 0; i < more; ++i) store.append(other, run_number(3 + i));
    const uint32_t taken = store.in_use();
    store.join(fragment, other);
    CHECK(store.in_use() == taken);
    std::vector<Run> expected = runs_from(0, 3 + more);
    expected[2] = Run::straight(2, run_number(2).length() + 7);
    CHECK(runs_of(store, fragment) == expected);
  }
}

TEST_CASE("a fragment is longer than any number below that of its nodes, and than no other") {
  Store<uint16_t> store(20);
  for (uint32_t count = 0; count < 6; ++count) {
    const uint32_t nodes = count > 0 ? count - 1 : 0;
    const Fragment<uint16_t> fragment = fragment_of(store, 0, count);
    for (uint32_t limit = 0; limit < 8; ++limit)
      CHECK(store.is_longer(fragment, limit) == (nodes > limit));
  }
}

TEST_CASE("a cleared store has all its nodes again") {
  Store<uint32_t> store(5);
  (void)fragment_of(store, 0, 6);
  CHECK(store.available() == 0);
  CHECK(store.high_water() == 5);
  store.clear();
  CHECK(store.available() == 5);
  CHECK(store.high_water() == 0);
  CHECK(runs_of(store, fragment_of(store, 2, 6)) == runs_from(2, 6));
}
