// Both ends of a slow link that fails, in one program. The device sends two surfaces per scan as
// one stream of slices, with the placement of the volume and time stamps. During the first scan the
// radio fails; the scan continues, and the stream resumes with the radio. The receiver extracts
// both surfaces, reports losses, and decodes scan after scan.
//
//   scan 1: no link for 433 bytes
//   scan 1, channel 0: 682 regions, 768 rows lost, the last stamp 2000 ms, x from -23.5 mm
//
// The names are qualified because discmc has short ones, such as Link, Run and Event.
#include <stdio.h>

#include <discmc/discmc.hpp>

namespace {

constexpr int32_t size = 48;  // voxels per row, rows per slice, slices
constexpr int32_t thresholds[] = {192, 224};
constexpr uint32_t surfaces = 2;
constexpr uint8_t time_stamp = 1;  // a kind of record: the application's own, below 240

// ---- the receiver ----

// Receives one surface, scan after scan. Two surfaces need two receivers, which both get all bytes.
class Surface {
 public:
  bool start(uint8_t channel) {
    channel_ = channel;
    return receiver_.start(discmc::memory_of(memory_), discmc::make_sink(*this), channel) ==
           discmc::Status::ok;
  }

  bool push(const uint8_t* bytes, size_t count) {
    for (;;) {
      const discmc::Decoded decoded = receiver_.push(bytes, count);
      bytes += decoded.bytes;
      count -= decoded.bytes;
      if (decoded.status == discmc::Status::finished) end_scan();
      const bool must_push_rest =
          decoded.status == discmc::Status::suspended ||  // rows are skipped
          decoded.status == discmc::Status::finished;
      if (!must_push_rest) return decoded.status == discmc::Status::ok;
    }
  }

  discmc::SinkResult accept(const discmc::Event& event) {
    // For a stream of slices the report counts only rows, so the regions are counted here.
    if (event.kind == discmc::Event::Kind::region_end) ++regions_;
    if (event.kind == discmc::Event::Kind::skipped) ++lost_rows_;  // the device skips none
    if (event.kind == discmc::Event::Kind::application) note(*event.application);
    return discmc::SinkResult::accepted;
  }

  uint32_t complete_scans() const { return complete_scans_; }

 private:
  void note(const discmc::ApplicationRecord& record) {
    (void)discmc::read_placement(record, placement_);  // if it is one
    if (record.kind == time_stamp && record.count == 2)
      milliseconds_ = record.bytes[0] + 256U * record.bytes[1];
  }

  void end_scan() {
    printf("scan %d, channel %d: %u regions, %u rows lost, the last stamp %u ms, x from %.1f mm\n",
           receiver_.header().scan, channel_, regions_, lost_rows_, milliseconds_,
           static_cast<double>(placement_.origin_nm[0]) / 1e6);
    if (receiver_.report().is_complete()) ++complete_scans_;
    regions_ = lost_rows_ = 0;
  }

  discmc::Receiver receiver_;
  uint8_t memory_[256 * 1024];  // more than Receiver::minimum_bytes(): no loose fragments come
  uint8_t channel_ = 0;
  unsigned regions_ = 0, lost_rows_ = 0, milliseconds_ = 0, complete_scans_ = 0;
  discmc::Placement placement_;
};

Surface received[surfaces];

// ---- the link ----

bool radio_works = true;

// Accepts what it has room for, and nothing while there is no link.
size_t radio_write(void*, const uint8_t* bytes, size_t count) {
  if (!radio_works) return 0;
  const size_t taken = count < 16 ? count : 16;
  for (Surface& surface : received)
    if (!surface.push(bytes, taken)) fputs("a receiver has stopped\n", stderr);
  return taken;
}

constexpr discmc::ByteOutput radio{nullptr, radio_write};

// ---- the device ----

constexpr discmc::Limits limits{size, size};
// A slice has 30 bytes here, so a packet holds eight: a lost one costs hardly more than itself.
constexpr uint32_t key_slice_interval = 8;

// RAM without the stack: 3 KiB.
discmc::SliceEncoder encoder;
uint8_t memory[discmc::SliceEncoder::minimum_bytes({limits, {}, key_slice_interval, surfaces})];

bool is_dropping = false;
uint64_t dropped_from = 0;

// Whether to call again. If the radio has accepted nothing for long, the link is dead, and the
// stream is dropped until it is back.
bool waits(discmc::Status status) {
  static unsigned refusals = 0;
  refusals = status == discmc::Status::suspended ? refusals + 1 : 0;
  if (refusals == 100) {
    is_dropping = true;
    dropped_from = encoder.bytes();
    encoder.set_output({});
  }
  return refusals > 0;  // sleep here
}

void connect_again() {
  is_dropping = false;
  encoder.set_output(radio);
  printf("scan 1: no link for %u bytes\n", static_cast<unsigned>(encoder.bytes() - dropped_from));
}

bool succeeds(discmc::Status status) {
  while (waits(status)) status = encoder.resume();
  return status == discmc::Status::ok;
}

bool write(const discmc::ApplicationRecord& record) {
  discmc::Status status = encoder.write_record(record);
  while (waits(status)) status = encoder.write_record(record);  // not accepted yet
  return status == discmc::Status::ok;
}

bool write_time(int32_t z) {
  const auto milliseconds = static_cast<uint16_t>(50 * z);
  const uint8_t bytes[] = {static_cast<uint8_t>(milliseconds & 0xFF),
                           static_cast<uint8_t>(milliseconds >> 8)};
  discmc::ApplicationRecord record;
  record.kind = time_stamp;
  record.bytes = bytes;
  record.count = sizeof bytes;
  return write(record);
}

bool write_place() {
  constexpr int32_t millimetre = 1000 * 1000;
  discmc::Placement placement;
  for (int axis = 0; axis < 3; ++axis) {
    placement.axes_nm[axis][axis] = millimetre;
    placement.origin_nm[axis] = (1 - size) * (millimetre / 2);
  }
  uint8_t bytes[discmc::Placement::record_bytes];
  return write(discmc::record_of(placement, bytes));
}

uint8_t sample_at(int32_t x, int32_t y, int32_t z) {  // of a ball, densest in its middle
  const discmc::Vertex v{2 * x - size + 1, 2 * y - size + 1, 2 * z - size + 1};
  return static_cast<uint8_t>(255 - discmc::dot_product(v, v) / 26);
}

bool scans(uint16_t number) {
  discmc::SliceEncoderConfig config{
      limits, {thresholds[0], thresholds[1]}, key_slice_interval, surfaces};
  config.label.depth = size;
  config.label.scan = number;  // so that packets of two scans differ
  bool good = succeeds(encoder.start(config, discmc::memory_of(memory), radio)) && write_place();
  for (int32_t z = 0; good && z < size; ++z) {
    radio_works = number != 1 || z < 16 || z >= 28;
    if (is_dropping && radio_works) connect_again();
    if (z % 8 == 0) good = write_time(z);  // rarely: each needs a packet
    for (int32_t y = 0; good && y < size; ++y) {
      uint8_t row[size];
      for (int32_t x = 0; x < size; ++x) row[x] = sample_at(x, y, z);
      good = succeeds(encoder.push(row, size).status);
    }
  }
  return good && succeeds(encoder.finish());
}

}  // namespace

int main() {
  bool good = received[0].start(0) && received[1].start(1);
  for (uint16_t scan = 1; good && scan <= 2; ++scan) good = scans(scan);
  for (const Surface& surface : received) good = good && surface.complete_scans() == 1;
  return good ? 0 : 1;
}
