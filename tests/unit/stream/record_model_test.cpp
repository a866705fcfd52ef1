// The region model: whatever is told in decisions comes back, at the ends of every range as well.
#include <doctest/doctest.h>
#include <discmc/stream/record_encoding.hpp>

#include <cmath>

#include "oracle/stream.hpp"
#include "oracle/table_statements.hpp"

using namespace discmc;
using test::Bytes;
using test::Chance;

namespace {

using Values = std::vector<int64_t>;

// Runs `tell` with a model that writes and with one that reads; it returns what was coded.
template <class Tell>
void check_round_trip(Tell tell, const Values& expected) {
  Bytes bytes(UINT16_MAX);
  RegionModel<test::WritingCoder> writer(test::WritingCoder{{bytes.data(), bytes.size()}});
  CHECK(tell(writer, true) == expected);
  REQUIRE(writer.coder().range.fits());
  bytes.resize(writer.coder().range.finish());
  RegionModel<test::ReadingCoder> reader(test::ReadingCoder{{bytes.data(), bytes.size()}});
  CHECK(tell(reader, false) == expected);
  CHECK_FALSE(reader.coder().range.is_exhausted());
}

// Around every power of two, and the ends: 0 to 2^32 - 2.
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

template <class Visit>
void for_each_incidence(Visit visit) {
  for (Incidence incidence = 0; incidence < incidence_codes; ++incidence)
    if (incidence != no_incidence) visit(incidence);
}

Record record_with(Incidence incidence) {
  Record record;
  record.incidence = incidence;
  return record;
}

constexpr ChainKind chains[] = {ChainKind::first, ChainKind::further, ChainKind::fragment,
                                ChainKind::backwards};

// The model begins the chain and tells its vertex, and before that, of a fragment, its first link.
template <class Model>
Vertex tell_vertex(Model& model, const Vertex& vertex, ChainKind chain, Direction first = 0) {
  if (!is_fragment(chain)) return model.start(vertex, chain);
  model.order(chain);
  model.direction(first);
  return model.fragment_vertex(vertex);
}

bool is_odd(const Vertex& vertex) {
  return ((vertex.x ^ vertex.y ^ vertex.z) & 1) != 0;
}

}  // namespace

TEST_CASE("every probability of the model is usable, and every context has one") {
  for (uint32_t i = 0; i < context::count; ++i) CHECK(region_model[i] >= 1);
  CHECK(sizeof(region_model) == context::count);
}

TEST_CASE("the probabilities are those of version 2") {
  CHECK(wire::version == 2);
  CHECK(reference::broken(reference::model_table()) == nullptr);
}

// Golden files hold few far steps: a context beyond the first ones of a number is seen here.
TEST_CASE("steps and lengths of every size are told as version 2 tells them") {
  Bytes bytes(UINT16_MAX);
  RegionModel<test::WritingCoder> model(test::WritingCoder{{bytes.data(), bytes.size()}});
  for_each_incidence([&](Incidence incidence) {
    model.incidence(incidence);
    for (int bits = 0; bits < 31; ++bits) {
      const int32_t far = int32_t{1} << bits;
      tell_vertex(model, {far, -far, 1}, chains[bits % 4]);
      tell_vertex(model, {-far, 2, far - 1}, chains[(bits / 4 + incidence) % 4], 1);
      model.run_count(static_cast<uint32_t>(far) + 1);
      for (uint32_t i = 0; i < 6; ++i) {
        model.direction(static_cast<Direction>((bits + 5 * static_cast<int>(i)) % 4));
        model.length(i < 4 ? i + 1 : static_cast<uint32_t>(far));
      }
    }
    model.layer(incidence);
  });
  bytes.resize(model.coder().range.finish());
  CHECK(bytes.size() == 49284);
  CHECK(crc32(bytes.data(), bytes.size()) == 0x2C9F3022);
}

TEST_CASE("small steps, and every direction after every other, are told as version 2 tells them") {
  Bytes bytes(UINT16_MAX);
  RegionModel<test::WritingCoder> model(test::WritingCoder{{bytes.data(), bytes.size()}});
  for_each_incidence([&](Incidence incidence) {
    model.incidence(incidence);
    Vertex at{0, 0, 1};
    for (int step = -4; step <= 4; ++step)
      for (const ChainKind chain : chains) {
        at = at + Vertex{2 * step, step, -step};
        tell_vertex(model, at, chain, static_cast<Direction>(step + 4) % 4);
        for (Direction i = 0; i < direction_count(incidence); ++i)
          for (Direction j = 0; j < direction_count(incidence); ++j) {
            model.direction(i);
            if (is_fragment(chain)) model.is_last_link(i < j);
            model.direction(j);
          }
      }
  });
  bytes.resize(model.coder().range.finish());
  CHECK(bytes.size() == 36853);
  CHECK(crc32(bytes.data(), bytes.size()) == 0xA8FB7461);
}

TEST_CASE("numbers come back: 0, around every power of two, 2^32 - 2") {
  const std::vector<uint32_t> values = numbers();
  check_round_trip(
      [&](auto& model, bool writes) {
        Values coded;
        for (const uint32_t value : values) coded.push_back(model.plain_number(writes ? value : 0));
        return coded;
      },
      Values(values.begin(), values.end()));
}

TEST_CASE("a number reads no more than 63 bits, whatever they are") {
  struct Ones {
    uint32_t* bits;
    bool code_bit(uint32_t, bool) { return ++*bits > 0; }
  };
  uint32_t bits = 0;
  RegionModel<Ones> model(Ones{&bits});
  CHECK(model.plain_number(0) == UINT32_MAX - 1);
  CHECK(bits == 32 + 31);
}

TEST_CASE("a number with contexts comes back in every class of planes") {
  const std::vector<uint32_t> values = numbers();
  for_each_incidence([&](Incidence incidence) {
    Values expected{incidence};
    for (const uint32_t value : values) {
      expected.push_back(uint32_t{value + 2});
      expected.push_back(uint32_t{value + 1});
    }
    check_round_trip(
        [&](auto& model, bool writes) {
          Values coded{model.incidence(writes ? incidence : no_incidence)};
          for (const uint32_t value : values) {
            coded.push_back(model.run_count(writes ? value + 2 : 2));
            coded.push_back(model.length(writes ? value + 1 : 1));
          }
          return coded;
        },
        expected);
  });
}

TEST_CASE("bits without a context come back") {
  const Values expected{0, 255, 0x5A, 0, 1, 0x7FFFFFFF};
  check_round_trip(
      [&](auto& model, bool writes) {
        const auto bits = [&](uint32_t count, uint32_t value) {
          return int64_t{model.plain_bits(count, writes ? value : 0)};
        };
        return Values{bits(8, 0), bits(8, 255), bits(8, 0x5A),
                      bits(1, 0), bits(1, 1),   bits(31, 0x7FFFFFFF)};
      },
      expected);
}

TEST_CASE("every incidence comes back after every other") {
  Values expected;
  for_each_incidence([&](Incidence a) {
    for_each_incidence([&](Incidence b) {
      expected.push_back(a);
      expected.push_back(b);
    });
  });
  check_round_trip(
      [&](auto& model, bool writes) {
        Values coded;
        for (const int64_t code : expected)
          coded.push_back(model.incidence(writes ? static_cast<Incidence>(code) : no_incidence));
        return coded;
      },
      expected);
}

TEST_CASE("starts anywhere on the lattice come back, near and at the ends of 32 bits") {
  Chance chance(1);
  const std::vector<int32_t> some = coordinates();
  const auto any = [&](int32_t near) {
    const int32_t step = static_cast<int32_t>(chance.below(13)) - 6;
    return chance.below(2) == 0 ? wrapped_sum(near, step)
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
        Incidence incidence = 0;
        for (const Vertex& start : starts) {
          const ChainKind chain = chains[static_cast<uint32_t>(start.y) % 4];
          model.incidence(writes ? incidence : no_incidence);
          const Vertex told = tell_vertex(model, writes ? start : Vertex{0, 0, 0}, chain);
          coded.insert(coded.end(), {told.x, told.y, told.z});
          incidence = incidence == 25 ? 0 : static_cast<Incidence>(incidence + 1);
          if (incidence == no_incidence) ++incidence;
          if (start.z % 5 == 0) model.layer(0);
        }
        return coded;
      },
      expected);
}

TEST_CASE("directions come back after every other direction, in every kind of chain") {
  for_each_incidence([&](Incidence incidence) {
    const uint32_t count = direction_count(incidence);
    for (const ChainKind chain : chains) {
      Values expected;
      for (uint32_t a = 0; a < count; ++a)
        for (uint32_t b = 0; b < count; ++b) expected.insert(expected.end(), {a, b, b, a});
      check_round_trip(
          [&](auto& model, bool writes) {
            Values coded;
            model.incidence(writes ? incidence : no_incidence);
            tell_vertex(model, writes ? Vertex{1, 0, 0} : Vertex{0, 0, 0}, chain);
            for (const int64_t direction : expected) {
              coded.push_back(model.direction(writes ? static_cast<Direction>(direction) : 0));
              model.length(1);
            }
            return coded;
          },
          expected);
    }
  });
}

TEST_CASE("kinds come back, in whatever state of the packet") {
  constexpr uint32_t kinds = static_cast<uint32_t>(RecordKind::layer) + 8;  // reserved ones as well
  Values expected;
  for (int state = 0; state < 5; ++state)
    for (uint32_t kind = 0; kind < kinds; ++kind) expected.push_back(kind);
  check_round_trip(
      [&](auto& model, bool writes) {
        Values coded;
        const auto all_kinds = [&] {
          for (uint32_t kind = 0; kind < kinds; ++kind)
            coded.push_back(static_cast<int64_t>(
                model.record_kind(static_cast<RecordKind>(writes ? kind : kinds - 1))));
        };
        model.incidence(writes ? Incidence{4} : no_incidence);
        all_kinds();
        for (const ChainKind chain : {ChainKind::first, ChainKind::fragment, ChainKind::further}) {
          tell_vertex(model, {1, 0, 0}, chain);
          all_kinds();
        }
        model.layer(0);
        all_kinds();
        return coded;
      },
      expected);
}

TEST_CASE("orders, items and parts come back") {
  const Values expected{2, 3, 0, 1, 2, 1, 0, 26, 5, 0, 1, 4};
  check_round_trip(
      [&](auto& model, bool writes) {
        Values coded;
        for (const ChainKind order : {ChainKind::fragment, ChainKind::backwards})
          coded.push_back(static_cast<int64_t>(model.order(writes ? order : ChainKind::fragment)));
        for (uint32_t kind = 0; kind < 3; ++kind)
          coded.push_back(
              static_cast<int64_t>(model.item_kind(static_cast<Item>(writes ? kind : 0))));
        Record fragment = record_with(writes ? Incidence{26} : no_incidence);
        fragment.is_fragment = writes;
        fragment.incoming = writes ? 5 : 0;
        model.part(fragment);
        coded.insert(coded.end(), {fragment.is_fragment, fragment.continues, fragment.incidence,
                                   fragment.incoming});
        Record region = record_with(writes ? Incidence{4} : no_incidence);
        region.continues = writes;
        model.part(region);
        coded.insert(coded.end(), {region.is_fragment, region.continues, region.incidence});
        return coded;
      },
      expected);
}

// Backwards, a chain is told in the turns that it makes forwards.
TEST_CASE("a chain told backwards costs about what it costs forwards") {
  struct Meter {
    double* bits;
    bool code_bit(uint32_t context, bool bit) {
      const double one = region_model[context] / 256.0;
      *bits -= std::log2(bit ? one : 1 - one);
      return bit;
    }
  };
  const auto cost = [](ChainKind order, const std::vector<Direction>& directions) {
    double bits = 0;
    RegionModel<Meter> model(Meter{&bits});
    model.incidence(0);
    tell_vertex(model, {1, 0, 0}, order, directions[0]);
    bits = 0;
    for (size_t i = 1; i < directions.size(); ++i) model.direction(directions[i]);
    return bits;
  };
  CHECK(cost(ChainKind::fragment, {0, 1, 2, 3}) ==
        doctest::Approx(cost(ChainKind::backwards, {3, 2, 1, 0})));
  CHECK(cost(ChainKind::fragment, {0, 1, 2, 3}) < cost(ChainKind::fragment, {3, 2, 1, 0}));
}

TEST_CASE("a ring is closed by any two directions and lengths, and by nothing else") {
  Chance chance(2);
  int closed = 0;
  for_each_incidence([&](Incidence incidence) {
    const uint32_t count = direction_count(incidence);
    for (uint32_t a = 0; a < count; ++a)
      for (uint32_t b = 0; b < count; ++b)
        for (const uint32_t most : {uint32_t{3}, max_compact_length}) {
          const Vertex u = direction_vector(incidence, static_cast<Direction>(a));
          const Vertex v = direction_vector(incidence, static_cast<Direction>(b));
          const int32_t m = static_cast<int32_t>(1 + chance.below(most));
          const int32_t n = static_cast<int32_t>(1 + chance.below(most));
          const Vertex way{m * u.x + n * v.x, m * u.y + n * v.y, m * u.z + n * v.z};
          const Closure closure = close_ring(u, v, way, static_cast<uint32_t>(m));
          CHECK(closure.is_valid);
          CHECK(closure.first == static_cast<uint32_t>(m));
          CHECK(closure.second == static_cast<uint32_t>(n));
          // Off the plane, and one of the lengths too many.
          CHECK_FALSE(close_ring(u, v, way + normal(incidence), 1).is_valid);
          const int32_t over = static_cast<int32_t>(max_compact_length) + 1 - n;
          const Vertex far{way.x + over * v.x, way.y + over * v.y, way.z + over * v.z};
          CHECK_FALSE(close_ring(u, v, far, static_cast<uint32_t>(m)).is_valid);
          ++closed;
        }
  });
  CHECK(closed == 2 * (6 * 64 + 12 * 16 + 8 * 36));
}

TEST_CASE("the ends of a part and of a packet take no more than their reserves") {
  const auto cost = [](uint32_t context, bool bit) {
    const double one = region_model[context] / 256.0;
    return -std::log2(bit ? one : 1 - one);
  };
  const auto tree = [&](uint32_t first, int bits, uint32_t value) {
    double sum = 0;
    uint32_t node = 1;
    for (int i = bits - 1; i >= 0; --i) {
      sum += cost(first + node - 1, (value >> i & 1) != 0);
      node = 2 * node + (value >> i & 1);
    }
    return sum;
  };
  // A byte less than the encoder's reserves of 4 bytes each, for the closing byte.
  constexpr uint32_t end =
      static_cast<uint32_t>(RecordKind::end) - static_cast<uint32_t>(RecordKind::layer);
  for (uint32_t before = 0; before < 5; ++before)
    CHECK(cost(context::region_follows + before, false) +
              cost(context::fragment_follows + before, false) + tree(context::other_kind, 3, end) <=
          24);
  for (const bool is_last : {false, true})
    CHECK(cost(context::item_kind, false) + cost(context::item_kind + 1, false) +
              cost(context::part_kind + 2, is_last) <=
          24);
}
