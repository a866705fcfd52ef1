// The model of records: all symbols are decoded unchanged, also at the ends of every range.
#include <discmc/stream/record_reading.hpp>
#include <discmc/stream/record_writing.hpp>

#include "incidences.hpp"
#include "oracle/stream.hpp"
#include "oracle/symbol_contexts.hpp"
#include "oracle/table_statements.hpp"
#include "test.hpp"

using namespace discmc;
using test::for_each_incidence;
using namespace discmc::detail::stream;
using test::Bytes;
using test::Chance;

namespace {

using Values = std::vector<int64_t>;
using WritingModel = RecordModel<SymbolWriter>;

// Calls `code` with a model that writes, then with one that reads. `code` returns the coded values.
template <class Code>
void check_round_trip(Code code, const Values& expected) {
  Bytes bytes(UINT16_MAX);
  WritingModel writer({RangeEncoder(bytes.data(), bytes.size())});
  CHECK(code(writer, true) == expected);
  REQUIRE(writer.coder().range.fits());
  bytes.resize(writer.coder().range.finish());
  ReadingModel reader({RangeDecoder(bytes.data(), bytes.size())});
  CHECK(code(reader, false) == expected);
  CHECK_FALSE(reader.coder().range.is_exhausted());
}

// Codes the values one by one, by code(model, value).
template <class Code>
void check_each(const Values& values, Code code) {
  check_round_trip(
      [&](auto& model, bool writes) {
        Values coded;
        for (const int64_t value : values) coded.push_back(code(model, writes ? value : 0));
        return coded;
      },
      values);
}

// Numbers around every power of two, and the bounds 0 and 2^32 - 2.
std::vector<uint32_t> numbers() {
  std::vector<uint32_t> values{0, UINT32_MAX - 1};
  for (int bits = 1; bits < 32; ++bits)
    for (uint32_t off = 0; off < 3; ++off) values.push_back((uint32_t{1} << bits) - 1 + off);
  return values;
}

std::vector<int32_t> coordinates() {
  std::vector<int32_t> values{0, INT32_MAX, INT32_MIN, INT32_MAX - 1, INT32_MIN + 1};
  for (int bits = 0; bits < 31; ++bits)
    for (const int32_t sign : {1, -1})
      for (int32_t off = -1; off <= 1; ++off) values.push_back(sign * (int32_t{1} << bits) + off);
  return values;
}

bool is_odd(const Vertex& vertex) {
  return ((vertex.x ^ vertex.y ^ vertex.z) & 1) != 0;
}

// Reads only the highest values.
struct Ones {
  static constexpr bool writes = false;
  uint32_t* bits;
  uint32_t symbol(uint32_t, uint32_t) { return contexts::of_number - 1; }
  uint32_t raw_bits(uint32_t count, uint32_t) {
    *bits += count;
    return (1U << count) - 1;
  }
};

// Adds up the costs of symbols.
struct Meter {
  static constexpr bool writes = true;
  double* bits;
  uint32_t symbol(uint32_t context, uint32_t symbol) {
    const uint8_t* const below = cumulative_frequencies + context + symbol;
    *bits -= std::log2(((below[1] - below[0]) & 0xFF) / 256.0);
    return symbol;
  }
  uint32_t raw_bits(uint32_t, uint32_t value) { return value; }
};

}  // namespace

TEST_CASE("contexts fill the frequency table, and exactly the valid symbols have a frequency") {
  const uint8_t* const below = cumulative_frequencies;
  uint32_t at = 0;
  for (const reference::SymbolContexts& of : reference::symbol_contexts()) {
    CAPTURE(of.name);
    CHECK(of.first == at);
    const bool are_corners = of.name == std::string("corners");
    const uint32_t link_class = of.symbols == 2 ? 0 : of.symbols == 9 ? 1 : 2;
    for (uint32_t context = 0; context < of.count; ++context, at += of.symbols) {
      CHECK(below[at] == 0);
      for (uint32_t i = 0; i < of.symbols; ++i) {
        const uint32_t next = at + i + 1;
        const uint32_t end = below[next] == 0 ? 256 : below[next];
        const bool is_valid = !are_corners || reference::has_corners(link_class, i);
        CHECK((below[at + i] < end && (i == 0 || below[at + i] > 0)) == is_valid);
      }
    }
  }
  CHECK(at == contexts::end);
  CHECK(below[at] == 0);
}

TEST_CASE("the frequencies of symbols are unchanged since version 1") {
  CHECK(detail::wire::version == 1);
  CHECK(reference::broken(reference::model_table()) == nullptr);
}

// Golden files have few long steps, so this test detects changed symbols of large numbers.
TEST_CASE("steps and lengths of every size are encoded in the bytes of version 1") {
  Bytes bytes(UINT16_MAX);
  WritingModel model({RangeEncoder(bytes.data(), bytes.size())});
  for_each_incidence([&](Incidence incidence) {
    for (int bits = 0; bits < 31; ++bits) {
      const int32_t far = int32_t{1} << bits;
      model.record_kind(static_cast<RecordKind>(bits % 4));
      model.start({far, -far, 1});
      model.start({-far, 2, far - 1});
      model.start({2 - far, 2, far - 1});
      model.start({far, 2, far - 1});
      model.start({far, 4, far - 1});
      model.start({far - 2, 2, far - 1});
      model.incidence(incidence);
      model.begin_chain(static_cast<Direction>(bits % 4));
      for (const Direction direction : {Direction{0}, Direction{1}}) {
        model.length(contexts::lengths, direction, static_cast<uint32_t>(far));
        model.length(contexts::longer, direction, static_cast<uint32_t>(far));
      }
    }
    model.layer(incidence);
  });
  bytes.resize(model.coder().range.finish());
  CHECK(bytes.size() == 32469);
  CHECK(crc32(bytes.data(), bytes.size()) == 0xDF237477);
}

TEST_CASE("small steps and all pairs of directions are encoded in the bytes of version 1") {
  Bytes bytes(UINT16_MAX);
  WritingModel model({RangeEncoder(bytes.data(), bytes.size())});
  for_each_incidence([&](Incidence incidence) {
    Vertex at{0, 0, 1};
    for (int step = -4; step <= 4; ++step)
      for (const RecordKind kind :
           {RecordKind::region, RecordKind::holed, RecordKind::forwards, RecordKind::backwards}) {
        model.record_kind(kind);
        at = at + Vertex{2 * step, step, -step};
        model.start(at);
        model.incidence(incidence);
        for (uint8_t i = 0; i < direction_count(incidence); ++i)
          for (uint8_t j = 0; j < direction_count(incidence); ++j) {
            model.chain_direction(i);
            model.run(Run::straight(j, 1U + (i + j) % 2));
            model.is_last_run(i < j);
          }
        model.ring_direction(static_cast<uint32_t>(step + 4));
        model.two_lengths(static_cast<uint32_t>(step + 4));
        model.corners(static_cast<uint32_t>(step + 4) % 2);
      }
  });
  bytes.resize(model.coder().range.finish());
  CHECK(bytes.size() == 54710);
  CHECK(crc32(bytes.data(), bytes.size()) == 0x60131C2C);
}

TEST_CASE("the numbers 0, around every power of two, and 2^32 - 2 are decoded unchanged") {
  const std::vector<uint32_t> values = numbers();
  check_each(Values(values.begin(), values.end()), [](auto& model, int64_t value) {
    return model.plain_number(static_cast<uint32_t>(value));
  });
}

TEST_CASE("a number needs one symbol and at most 37 bits") {
  uint32_t bits = 0;
  RecordModel<Ones> model(Ones{&bits});
  CHECK(model.plain_number(0) == UINT32_MAX - 1);
  CHECK(bits == 5 + 32);
}

TEST_CASE("lengths are decoded unchanged in every class of planes and every direction") {
  const std::vector<uint32_t> values = numbers();
  for_each_incidence([&](Incidence incidence) {
    Values expected;
    for (const uint32_t value : values) expected.insert(expected.end(), 2, uint32_t{value + 1});
    check_round_trip(
        [&](auto& model, bool writes) {
          Values coded;
          model.start({1, 1, 1});
          model.incidence(writes ? incidence : no_incidence);
          for (const uint32_t value : values)
            for (const uint32_t context : {contexts::lengths, contexts::longer})
              coded.push_back(
                  model.length(context, static_cast<Direction>(value % 2), writes ? value + 1 : 1));
          return coded;
        },
        expected);
  });
}

TEST_CASE("raw bits in records are decoded unchanged") {
  const Values expected{0, 255, 0x5A, 0, 1, 0x7FFFFFFF, 0x89ABCDEF};
  check_round_trip(
      [&](auto& model, bool writes) {
        const auto bits = [&](uint32_t count, uint32_t value) {
          return int64_t{model.raw_bits(count, writes ? value : 0)};
        };
        return Values{bits(8, 0), bits(8, 255),         bits(8, 0x5A),       bits(1, 0),
                      bits(1, 1), bits(31, 0x7FFFFFFF), bits(32, 0x89ABCDEF)};
      },
      expected);
}

// On edges of the same voxel and of another voxel, and at a centroid.
TEST_CASE("all pairs of incidences are decoded unchanged at every kind of vertex") {
  const Vertex vertices[] = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {1, 1, 1}, {3, 0, 0}, {2, 1, 0}};
  Values expected;
  for_each_incidence([&](Incidence a) {
    for_each_incidence([&](Incidence b) {
      for (int i = 0; i < 6; ++i) expected.insert(expected.end(), {a, b});
    });
  });
  check_round_trip(
      [&](auto& model, bool writes) {
        Values coded;
        for (size_t i = 0; i < expected.size(); ++i) {
          model.start(vertices[i % 2 == 0 ? i / 2 % 6 : i / 12 % 6]);
          coded.push_back(
              model.incidence(writes ? static_cast<Incidence>(expected[i]) : no_incidence));
        }
        return coded;
      },
      expected);
}

TEST_CASE("starts anywhere on the lattice are decoded unchanged, even at the limits of 32 bits") {
  Chance chance(1);
  const std::vector<int32_t> some = coordinates();
  const auto any = [&](int32_t near) {
    const int32_t step = static_cast<int32_t>(chance.below(13)) - 6;
    return chance.below(2) == 0
               ? static_cast<int32_t>(static_cast<uint32_t>(near) + static_cast<uint32_t>(step))
               : some[chance.below(static_cast<uint32_t>(some.size()))];
  };
  std::vector<Vertex> starts{{1, 0, 0}};
  while (starts.size() < 3000) {
    const Vertex before = starts.back();
    const Vertex start{any(before.x), any(before.y), any(before.z)};
    if (is_odd(start)) starts.push_back(start);
  }
  Values expected;
  for (const Vertex& start : starts) expected.insert(expected.end(), {start.x, start.y, start.z});
  check_round_trip(
      [&](auto& model, bool writes) {
        Values coded;
        for (const Vertex& start : starts) {
          const Vertex coded_start = model.start(writes ? start : Vertex{0, 0, 0});
          coded.insert(coded.end(), {coded_start.x, coded_start.y, coded_start.z});
        }
        return coded;
      },
      expected);
}

TEST_CASE("all pairs of directions are decoded unchanged in every kind of chain") {
  for_each_incidence([&](Incidence incidence) {
    const uint32_t count = direction_count(incidence);
    for (const RecordKind kind :
         {RecordKind::region, RecordKind::forwards, RecordKind::backwards}) {
      Values expected;
      for (uint32_t a = 0; a < count; ++a)
        for (uint32_t b = 0; b < count; ++b) expected.insert(expected.end(), {a, b, b, a});
      check_round_trip(
          [&](auto& model, bool writes) {
            Values coded;
            model.record_kind(kind);
            model.start({1, 1, 1});
            model.incidence(writes ? incidence : no_incidence);
            for (size_t i = 0; i < expected.size(); ++i) {
              const auto direction = writes ? static_cast<Direction>(expected[i]) : Direction{0};
              if (i % 2 == 0) {
                coded.push_back(model.chain_direction(direction));
              } else {
                const auto length = static_cast<uint32_t>(1 + i % 5);
                const Run run = model.run(writes ? Run::straight(direction, length) : Run());
                CHECK(run.length() == length);
                coded.push_back(run.direction());
              }
            }
            return coded;
          },
          expected);
    }
  });
}

TEST_CASE("record kinds are decoded unchanged after any two previous kinds") {
  constexpr uint32_t kinds = contexts::of_kinds;
  Values expected;
  for (uint32_t a = 0; a < kinds; ++a)
    for (uint32_t b = 0; b < kinds; ++b)
      for (uint32_t c = 0; c < kinds; ++c) expected.insert(expected.end(), {a, b, c});
  check_each(expected, [](auto& model, int64_t kind) {
    return static_cast<int64_t>(model.record_kind(static_cast<RecordKind>(kind)));
  });
}

TEST_CASE("the symbols of a ring are decoded unchanged") {
  for_each_incidence([&](Incidence incidence) {
    const uint32_t link_class = class_of(incidence);
    Values expected;
    for (uint32_t i = 0; i < contexts::of_corners(link_class); ++i)
      if (reference::has_corners(link_class, i)) expected.push_back(i);
    for (uint32_t i = 0; i < direction_count(incidence); ++i) expected.push_back(i);
    for (uint32_t i = 0; i < 16; ++i) expected.push_back(i);
    expected.insert(expected.end(), {0, 1});
    check_round_trip(
        [&](auto& model, bool writes) {
          Values coded;
          const auto next_symbol = [&] {
            return writes ? static_cast<uint32_t>(expected[coded.size()]) : 0;
          };
          model.start({1, 1, 1});
          model.incidence(writes ? incidence : no_incidence);
          for (uint32_t i = 0; i < contexts::of_corners(link_class); ++i)
            if (reference::has_corners(link_class, i))
              coded.push_back(model.corners(next_symbol()));
          for (uint32_t i = 0; i < direction_count(incidence); ++i)
            coded.push_back(model.ring_direction(next_symbol()));
          for (uint32_t i = 0; i < 16; ++i) coded.push_back(model.two_lengths(next_symbol()));
          model.begin_chain(0);
          coded.push_back(model.is_last_run(next_symbol() != 0));
          coded.push_back(model.is_last_run(next_symbol() != 0));
          return coded;
        },
        expected);
  });
}

TEST_CASE("the flags and incidence of a part are decoded unchanged") {
  Values expected;
  for (int64_t flags = 0; flags < 16; ++flags)
    expected.insert(expected.end(), {flags & 1, flags >> 1 & 1, flags >> 2 & 1, flags >> 3, 26});
  check_round_trip(
      [&](auto& model, bool writes) {
        Values coded;
        for (uint32_t flags = 0; flags < 16; ++flags) {
          Record record;
          record.incidence = writes ? Incidence{26} : no_incidence;
          record.is_last = writes && (flags & 2) != 0;
          record.continues = writes && (flags & 4) != 0;
          record.is_fragment = writes && (flags & 8) != 0;
          const bool begins_ring = model.part(record, writes && (flags & 1) != 0);
          coded.insert(coded.end(), {begins_ring, record.is_last, record.continues,
                                     record.is_fragment, record.incidence});
        }
        return coded;
      },
      expected);
}

// A chain coded backwards uses the turns that it makes forwards.
TEST_CASE("a chain costs about as many bits coded backwards as coded forwards") {
  const auto cost = [](RecordKind kind, const std::vector<Direction>& directions) {
    double bits = 0;
    RecordModel<Meter> model(Meter{&bits});
    model.record_kind(kind);
    model.start({1, 1, 1});
    model.incidence(0);
    model.chain_direction(directions[0]);
    bits = 0;
    for (size_t i = 1; i < directions.size(); ++i) model.run(Run::straight(directions[i], 1));
    return bits;
  };
  CHECK(cost(RecordKind::forwards, {0, 1, 2, 3}) ==
        doctest::Approx(cost(RecordKind::backwards, {3, 2, 1, 0})));
  CHECK(cost(RecordKind::forwards, {0, 1, 2, 3}) < cost(RecordKind::forwards, {3, 2, 1, 0}));
}

TEST_CASE("close_ring() returns the two lengths that lead back to the start") {
  Chance chance(2);
  int closed = 0;
  for (uint32_t link_class = 0; link_class < 3; ++link_class) {
    const uint32_t count = 4 + 2 * link_class;
    const PlaneStep* const steps = plane_steps_of(link_class);
    for (uint32_t i = 0; i < count; ++i)
      for (uint32_t j = 0; j < count; ++j) {
        if (i % (count / 2) == j % (count / 2)) continue;  // parallel
        const PlaneStep a = steps[i], b = steps[j];
        for (const uint32_t most : {uint32_t{3}, max_compact_length}) {
          const auto m = static_cast<int32_t>(1 + chance.below(most));
          const auto n = static_cast<int32_t>(1 + chance.below(most));
          const PlaneVector vector{m * a.u + n * b.u, m * a.v + n * b.v};
          const Closure closure = close_ring(a, b, vector);
          CHECK(closure.is_valid);
          CHECK(closure.first == static_cast<uint32_t>(m));
          CHECK(closure.second == static_cast<uint32_t>(n));
          // One length too many, or none left.
          const int32_t over = static_cast<int32_t>(max_compact_length) + 1;
          CHECK_FALSE(close_ring(a, b, {over * a.u + n * b.u, over * a.v + n * b.v}).is_valid);
          CHECK_FALSE(close_ring(a, b, {m * a.u + over * b.u, m * a.v + over * b.v}).is_valid);
          CHECK_FALSE(close_ring(a, b, {n * b.u, n * b.v}).is_valid);
          CHECK_FALSE(close_ring(a, b, {m * a.u - n * b.u, m * a.v - n * b.v}).is_valid);
          ++closed;
        }
      }
  }
  CHECK(closed == 2 * (4 * 2 + 6 * 4 + 8 * 6));
  // Half a link. If only the one length is whole, the ring is invalid, too.
  CHECK_FALSE(close_ring(plane_steps_of(2)[0], plane_steps_of(2)[2], {3, 2}).is_valid);
  CHECK_FALSE(close_ring(plane_steps_of(2)[0], plane_steps_of(2)[2], {2, 3}).is_valid);
  CHECK_FALSE(close_ring(plane_steps_of(2)[0], plane_steps_of(2)[2], {2, 1}).is_valid);
  CHECK_FALSE(close_ring(plane_steps_of(2)[0], plane_steps_of(2)[2], {1, 2}).is_valid);
}

TEST_CASE(
    "run_along() returns the run between two points along a direction, otherwise an empty run") {
  for (uint32_t link_class = 0; link_class < 3; ++link_class) {
    const uint32_t count = 4 + 2 * link_class;
    const PlaneStep* const steps = plane_steps_of(link_class);
    for (uint8_t d = 0; d < count; ++d) {
      const auto vector = [&](uint32_t length) {
        const auto times = static_cast<int32_t>(length);
        return PlaneVector{times * steps[d].u, times * steps[d].v};
      };
      for (const uint32_t length : {1U, 2U, 7U, max_compact_length})
        CHECK(run_along(steps, count, vector(length)).code() == Run::straight(d, length).code());
      CHECK(run_along(steps, count, vector(max_compact_length + 1)).is_empty());
    }
    CHECK(run_along(steps, count, {0, 0}).is_empty());
    CHECK(run_along(steps, count, {7, 3}).is_empty());
  }
  CHECK(run_along(plane_steps_of(2), 8, {3, 0}).is_empty());  // half a link
}

// A ring closes in steps of the plane exactly if it closes in space.
TEST_CASE("plane steps add up to zero exactly if the links add up to zero") {
  for_each_incidence([&](Incidence incidence) {
    const PlaneStep* const steps = plane_steps_of(class_of(incidence));
    const uint32_t count = direction_count(incidence);
    for (uint8_t i = 0; i < count; ++i)
      for (uint8_t j = 0; j < count; ++j)
        for (uint8_t k = 0; k < count; ++k) {
          const Vertex sum = direction_vector(incidence, i) + direction_vector(incidence, j) -
                             direction_vector(incidence, k);
          const bool is_none = sum == Vertex{0, 0, 0};
          const bool is_closed =
              steps[i].u + steps[j].u == steps[k].u && steps[i].v + steps[j].v == steps[k].v;
          CHECK(is_none == is_closed);
        }
  });
}

TEST_CASE("first_back() returns the first direction of a plane that leads back") {
  for_each_incidence([&](Incidence incidence) {
    const auto leads_back = [&](uint32_t direction) {
      const Vertex v = direction_vector(
          incidence, static_cast<Direction>(direction % direction_count(incidence)));
      return v.z < 0 || (v.z == 0 && (v.y < 0 || (v.y == 0 && v.x < 0)));
    };
    const uint32_t first = first_back(incidence);
    CHECK(leads_back(first));
    CHECK_FALSE(leads_back(first + direction_count(incidence) - 1U));
  });
}

TEST_CASE("corners_of() returns 0 for a ring with a half turn") {
  const auto corners = [](const std::vector<Direction>& directions) {
    std::vector<uint32_t> runs;
    for (const Direction direction : directions) runs.push_back(Run::straight(direction, 1).code());
    return corners_of(runs.data(), static_cast<uint32_t>(runs.size()), 8);
  };
  CHECK(corners({0, 2, 4, 6}) != 0);
  for (const std::vector<Direction>& half :
       {std::vector<Direction>{0, 4, 5, 6}, {0, 1, 5, 6}, {0, 1, 2, 6}, {0, 4, 6}})
    CHECK(corners(half) == 0);
}

TEST_CASE("a fragment is coded from its nearer end, by cost: slice 64, row 8, voxel 1") {
  // A fragment whose ends are at given distances in voxels from the previous vertex.
  const auto is_nearer = [](Vertex start, Vertex end) {
    const Vertex before{1, 100, 100};
    Record record;
    record.begin(start.x == end.x ? incidence_of({1, 0, 0}) : incidence_of({0, 0, 1}));
    record.begin_fragment(0, before + start + start);
    const auto go = [&](Vertex step, int32_t voxels) {
      for (Direction d = 0; voxels != 0 && d < direction_count(record.incidence); ++d)
        if (direction_vector(record.incidence, d) == (voxels < 0 ? Vertex{} - step : step))
          record.add_run(Run::straight(d, static_cast<uint32_t>(voxels < 0 ? -voxels : voxels)));
    };
    go({0, 0, 2}, end.z - start.z);
    if (start.x == end.x) go({0, 2, 0}, end.y - start.y + 1);
    if (start.x != end.x) go({0, 2, 0}, end.y - start.y);
    if (start.x != end.x) go({2, 0, 0}, end.x - start.x + 1);
    Vertex vertex;
    const bool is_end = is_nearer_at_end(record, before, vertex);
    const Vertex nearer = is_end ? end : start;
    CHECK(vertex == before + nearer + nearer);
    return is_end;
  };
  CHECK_FALSE(is_nearer({0, 0, 1}, {0, 8, 0}));
  CHECK(is_nearer({0, 0, 1}, {0, 7, 0}));
  CHECK(is_nearer({0, 0, -1}, {0, 7, 0}));
  CHECK_FALSE(is_nearer({0, 1, 0}, {8, 0, 0}));
  CHECK(is_nearer({0, 1, 0}, {7, 0, 0}));
}

TEST_CASE("a part without a run is refused by the reader") {
  Record record;
  record.begin(no_incidence);
  record.add_ring({1, 0, 0});
  Bytes bytes(100);
  WritingModel writer({RangeEncoder(bytes.data(), bytes.size())});
  encode_part(writer, record, Record::ring_words);
  writer.raw_bits(8, 0xA5);
  bytes.resize(writer.coder().range.finish());
  ReadingModel reader({RangeDecoder(bytes.data(), bytes.size())});
  CHECK(reader.record_kind(RecordKind::end) == RecordKind::part);
  CHECK(reader.raw_bits(4, 0) == 15);
  CHECK(reader.raw_bits(8, 0) == 0xA5);
}
