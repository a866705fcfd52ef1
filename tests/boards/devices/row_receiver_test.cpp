// Rows over a line: complete rows are accepted once and in order, and nothing else is.
#include <rows/row_receiver.hpp>

#include "oracle/stream.hpp"
#include "test.hpp"

using discmc::test::Bytes;
using discmc::test::Chance;
using row_frame::Kind;
using Event = RowReceiver::Event;
using Events = std::vector<Event>;

namespace {

constexpr size_t row_bytes = 12;

Bytes frame(Kind kind, uint32_t number, const Bytes& samples = {}) {
  Bytes bytes(row_frame::max_bytes, 0xEE);
  bytes.resize(row_frame::write(bytes.data(), kind, number, samples.data(), samples.size()));
  return bytes;
}
Bytes start_frame() {
  return frame(Kind::start, row_bytes);
}

// Samples with zeros, which need stuffing, and different ones in every row.
Bytes samples_of(uint32_t number, size_t count = row_bytes) {
  Bytes samples(count);
  for (size_t i = 0; i < count; ++i) samples[i] = static_cast<uint8_t>(i % 3 * (number + i));
  return samples;
}
Bytes row_frame_of(uint32_t number) {
  return frame(Kind::row, number, samples_of(number));
}

Bytes joined(std::initializer_list<Bytes> parts) {
  Bytes all;
  for (const Bytes& part : parts) all.insert(all.end(), part.begin(), part.end());
  return all;
}

// A device with one buffer, which is free if `is_free`. Sanitizers detect a byte beyond the buffer.
struct Device {
  RowReceiver receiver{row_bytes};
  Bytes half = Bytes(row_bytes, 0xCC);
  bool is_free = true;

  Events accept(const Bytes& bytes) {
    Events events;
    for (const uint8_t byte : bytes) {
      const Event event = receiver.accept(byte, is_free ? half.data() : nullptr);
      if (event != Event::nothing) events.push_back(event);
    }
    return events;
  }
  void accept_row(uint32_t number) {
    CHECK(accept(row_frame_of(number)) == Events{Event::row});
    CHECK(receiver.number() == number);
    CHECK(half == samples_of(number));
  }
};

Device started() {
  Device device;
  CHECK(device.accept(start_frame()) == Events{Event::start});
  return device;
}

}  // namespace

TEST_CASE("a row receiver receives a scan of three rows") {
  Device device = started();
  for (uint32_t number = 0; number < 3; ++number) device.accept_row(number);
  CHECK(device.accept(frame(Kind::end, 3)) == Events{Event::end});
  CHECK(device.receiver.number() == 3);
}

TEST_CASE("rows of any length that fits a frame, and of any number, are received") {
  for (size_t count = 1; count <= row_frame::max_samples; ++count) {
    CAPTURE(count);
    const uint32_t number = static_cast<uint32_t>(count) * 17000000U;
    RowReceiver receiver(count);
    Bytes half(count);
    Event event = Event::nothing;
    for (const uint8_t byte : frame(Kind::start, static_cast<uint32_t>(count)))
      event = receiver.accept(byte, half.data());
    CHECK(event == Event::start);
    for (const uint8_t byte : frame(Kind::row, number, samples_of(number, count)))
      event = receiver.accept(byte, half.data());
    CHECK(event == Event::row);
    CHECK(receiver.number() == number);
    CHECK(half == samples_of(number, count));
  }
}

TEST_CASE("a flipped bit in a frame loses only that frame's row") {
  const Bytes good = row_frame_of(1);
  for (size_t place = 0; place < good.size(); ++place) {
    for (uint32_t bit = 0; bit < 8; ++bit) {
      INFO("place ", place, ", bit ", bit);
      Device device = started();
      device.accept_row(0);
      Bytes bad = good;
      bad[place] = static_cast<uint8_t>(bad[place] ^ 1U << bit);
      bad.push_back(0);  // as every frame begins, because the wrong bit may be in the last zero
      const Events events = device.accept(bad);
      CHECK(std::count(events.begin(), events.end(), Event::row) == 0);
      device.accept_row(2);
    }
  }
}

TEST_CASE("a frame truncated at any byte loses only its own row") {
  const Bytes whole = row_frame_of(1);
  for (size_t count = 0; count < whole.size(); ++count) {
    CAPTURE(count);
    Device device = started();
    device.accept_row(0);
    CHECK(device.accept(Bytes(whole.begin(), whole.begin() + static_cast<std::ptrdiff_t>(count)))
              .empty());
    const Events events = device.accept(row_frame_of(2));
    // All bytes but the last zero may be missing; the next frame begins with a zero.
    const bool is_whole = count + 1 == whole.size();
    const bool is_reported = count > 1;
    CHECK(events == (is_whole      ? Events{Event::row, Event::row}
                     : is_reported ? Events{Event::dropped, Event::row}
                                   : Events{Event::row}));
    CHECK(device.half == samples_of(2));
  }
}

TEST_CASE("rows of a wrong length are dropped without a write beyond the half of the buffer") {
  for (const size_t count : {size_t{0}, row_bytes - 1, row_bytes + 1, row_frame::max_samples}) {
    CAPTURE(count);
    Device device = started();
    CHECK(device.accept(frame(Kind::row, 0, samples_of(0, count))) == Events{Event::dropped});
    device.accept_row(0);
  }
}

TEST_CASE("frames longer than the maximum are dropped") {
  Device device = started();
  Bytes bytes(1000, 0xFF);
  bytes.push_back(0);
  CHECK(device.accept(bytes) == Events{Event::dropped});
  device.accept_row(0);
}

TEST_CASE("repeated and late rows are dropped, and gaps in the numbers are accepted") {
  Device device = started();
  device.accept_row(5);
  CHECK(device.accept(row_frame_of(5)) == Events{Event::dropped});
  CHECK(device.accept(row_frame_of(4)) == Events{Event::dropped});
  device.accept_row(6);
  device.accept_row(1000);
}

TEST_CASE("a row with the highest number is dropped, and row numbers do not wrap to 0") {
  Device device = started();
  CHECK(device.accept(row_frame_of(UINT32_MAX)) == Events{Event::dropped});
  device.accept_row(UINT32_MAX - 1);
  CHECK(device.accept(row_frame_of(0)) == Events{Event::dropped});
}

TEST_CASE("a row is dropped if the buffer has no room at any of its samples") {
  const Bytes bytes = row_frame_of(0);
  for (size_t place = 0; place < bytes.size(); ++place) {
    CAPTURE(place);
    Device device = started();
    Event last = Event::nothing;
    for (size_t i = 0; i < bytes.size(); ++i)
      last = device.receiver.accept(bytes[i], i == place ? nullptr : device.half.data());
    const bool is_sample =
        place >= 2 + row_frame::head_bytes && place < 2 + row_frame::head_bytes + row_bytes;
    CHECK(last == (is_sample ? Event::dropped : Event::row));
  }
  Device device = started();
  device.is_free = false;
  CHECK(device.accept(bytes) == Events{Event::dropped});
  CHECK(device.half == Bytes(row_bytes, 0xCC));
  device.is_free = true;
  device.accept_row(0);
}

TEST_CASE("zeros and garbage between frames are ignored") {
  Chance chance(1);
  Device device = started();
  for (uint32_t number = 0; number < 500; ++number) {
    device.accept(Bytes(chance.below(4), 0));
    Bytes garbage(chance.below(600));
    for (uint8_t& byte : garbage) byte = chance.byte();
    const Events events = device.accept(garbage);
    CHECK(std::count(events.begin(), events.end(), Event::dropped) ==
          static_cast<std::ptrdiff_t>(events.size()));
    const Events ended = device.accept({0});
    CHECK(ended.size() <= 1);
    device.accept_row(number);
  }
}

TEST_CASE("frames before the start are ignored") {
  Device device;
  CHECK(device.accept(joined({row_frame_of(7), {3, 1, 4, 1, 0}, frame(Kind::end, 8)})).empty());
  CHECK(device.accept(start_frame()) == Events{Event::start});
  device.accept_row(0);
}

TEST_CASE("a repeated start frame is accepted until the first row, and after the end") {
  Device device = started();
  CHECK(device.accept(start_frame()) == Events{Event::start});
  device.accept_row(0);
  CHECK(device.accept(start_frame()) == Events{Event::refused});
  device.accept_row(1);
  CHECK(device.accept(frame(Kind::end, 2)) == Events{Event::end});
  CHECK(device.accept(start_frame()) == Events{Event::start});
  device.accept_row(0);
}

TEST_CASE("a start for rows of another size is refused, and its rows are ignored") {
  Device device;
  CHECK(device.accept(frame(Kind::start, row_bytes + 1)) == Events{Event::refused});
  CHECK(device.accept(row_frame_of(0)).empty());
}

TEST_CASE("the end of a scan is reported once, with its kind") {
  Device device = started();
  device.accept_row(4);
  CHECK(device.accept(frame(Kind::end, 4)) ==
        Events{Event::dropped});  // of fewer rows than have arrived
  CHECK(device.accept(frame(Kind::broken_off, 9)) == Events{Event::broken_off});
  CHECK(device.receiver.number() == 9);
  CHECK(device.accept(joined({frame(Kind::broken_off, 9), row_frame_of(9)})).empty());
}

TEST_CASE("frames of unknown kinds are dropped") {
  Device device = started();
  CHECK(device.accept(frame(static_cast<Kind>(4), 0)) == Events{Event::dropped});
  CHECK(device.accept(frame(Kind::end, 0, {1})) == Events{Event::dropped});
  device.accept_row(0);
}
