// Fuzz target. A stream of slices transmits any small volume unchanged, with fractions or without,
// for any portions, key slices, flushes, refusals and power failures. After lost, damaged or forged
// packets the rows still arrive in order and once each. All rows are right if no packet is forged.
// Decoding never faults and always ends.
//
//   fuzz_slices -max_len=600 corpus/slices      with libFuzzer
//   fuzz_slices corpus/slices                   with replay_main.cpp
#include "input.hpp"
#include "oracle/slice_stream.hpp"
#include "require.hpp"
#include "small_volume.hpp"

using namespace discmc;
using namespace discmc::test;
using reference::BitVolume;
using reference::samples_with;
using Kind = RowEvent::Kind;

namespace {

SlicePlan read_plan(Input& input) {
  SlicePlan plan;
  plan.key_slice_interval = input.below(5);
  plan.portion = 1 + input.byte();
  plan.bytes_at_once = input.below(20);
  const uint32_t flushing = input.below(216);
  plan.flush_every = flushing % 9;
  plan.surface_count = static_cast<uint8_t>(1 + flushing / 9 % 4);
  plan.fails = flushing / 36 % 2 != 0;
  plan.levels = static_cast<uint8_t>(flushing / 72 * 2);
  return plan;
}

// Keeps, drops or replaces packets.
Bytes mangled(const Bytes& stream, Input& input, bool& is_made_up) {
  Bytes result;
  for (const Bytes& frame : frames_of(stream)) {
    const uint32_t what = input.byte();
    Bytes sent = frame;
    if (what >= 250) {
      Packet packet = packet_of(frame);
      packet.kind = static_cast<uint8_t>(packet.kind ^ input.below(32));
      const Bytes payload = input.bytes(1 + input.byte());
      if (payload.size() <= detail::wire::max_payload) packet.payload = payload;
      sent = frame_of(packet);
      is_made_up = true;
    } else if (what >= 230) {
      sent.clear();
    } else if (what >= 210) {
      sent[input.byte() % sent.size()] = static_cast<uint8_t>(input.byte());
    } else if (what >= 200) {
      sent.insert(sent.end(), frame.begin(), frame.end());
    }
    result.insert(result.end(), sent.begin(), sent.end());
  }
  return result;
}

// Returns whether all rows of the volume were sent.
bool check_rows(const BitVolume& volume, const SlicePlan& plan, const ReceivedRows& received,
                bool is_made_up) {
  require(is_made_up || plan.levels == 0 ||
              have_fractions(received.rows, samples_with(volume), 100, plan.levels),
          "fractions that are wrong");
  std::vector<uint16_t> first_fractions;
  size_t next = 0;
  uint64_t sent = 0;
  Bytes first_bits;  // of the first surface
  for (const RecordedRow& row : received.rows) {
    if (row.is(Kind::finish)) break;
    if (row.is(Kind::application)) continue;
    const size_t at = size_t{row.event.slice} * volume.height + row.event.row;
    if (!row.is(Kind::lost) && row.event.channel > 0) {
      require(at + 1 == next && (is_made_up || row.bits == first_bits),
              "a row of another surface that is wrong");
      require(is_made_up || row.fractions == first_fractions,
              "fractions of another surface that are wrong");
      continue;
    }
    require(at == next, "a row out of its order");
    first_bits = row.bits;
    first_fractions = row.fractions;
    next += row.is(Kind::lost) ? static_cast<size_t>(row.event.count) : 1;
    if (row.is(Kind::lost) || is_made_up) continue;
    const uint8_t* const first = &volume.on[at * volume.width];
    require(row.bits == Bytes(first, first + volume.width), "a row that is wrong");
    ++sent;
  }
  return sent == uint64_t{volume.height} * volume.depth;
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const uint8_t* data, size_t size) {
  Input input(data, size);
  const SlicePlan plan = read_plan(input);
  const size_t portion = 1 + input.below(30);
  const BitVolume volume = read_small_volume(input, {70, 9, 12});
  const uint32_t surfaces = plan.surface_count;
  const reference::Size slice{volume.width, volume.height, volume.depth};
  const Bytes stream = encode_slices(volume, plan);
  const ReceivedRows whole = decode_slices(stream, slice, portion, true, surfaces, plan.levels);
  require(whole.report.is_complete(), "a whole stream that is not complete");
  require(check_rows(volume, plan, whole, false), "a row that is missing");

  bool is_made_up = false;
  const Bytes sent = mangled(stream, input, is_made_up);
  const ReceivedRows arrived = decode_slices(sent, slice, 0, false, surfaces, plan.levels);
  check_rows(volume, plan, arrived, is_made_up);
  const ReceivedRows again = decode_slices(sent, slice, portion, true, surfaces, plan.levels);
  require(again.rows.size() == arrived.rows.size(), "portions or refusals show");
  require(again.report.lost_rows == arrived.report.lost_rows, "the report depends on them");
  return 0;
}
