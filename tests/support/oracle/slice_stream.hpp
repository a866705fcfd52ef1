// Writes streams of slices for tests, and reads them back as rows.
#pragma once

#include <cstring>
#include <discmc/fraction_slice_encoder.hpp>
#include <discmc/receiver.hpp>
#include <discmc/slice_decoder.hpp>
#include <utility>

#include "fractions.hpp"
#include "slice_config.hpp"
#include "stream.hpp"

namespace discmc::test {

/// A started slice encoder in memory of its own.
struct StartedSliceEncoder : SliceEncoder {
  StartedSliceEncoder(const StreamHeader& header, const ByteOutput& output,
                      uint32_t key_slice_interval = 0) {
    const SliceEncoderConfig config = slice_config(header, key_slice_interval);
    block = reference::Block(minimum_bytes(config));
    reference::require_ok(start(config, block.memory(), output));
  }

  reference::Block block{0};
};

/// The options for encoding a volume.
struct SlicePlan {
  uint32_t key_slice_interval = 0;
  uint32_t portion = 1000000;  ///< samples per push
  size_t bytes_at_once = 0;    ///< that the line accepts: see Line
  uint32_t flush_every = 0;    ///< rows between flushes; 0 never
  bool fails = false;          ///< whether power fails after each flush and before the end
  uint8_t surface_count = 1;   ///< all surfaces are equal
  uint8_t levels = 0;          ///< of the fractions of samples_with()
};

template <class AnyEncoder, class Sample>
void push_rows(AnyEncoder& encoder, const Sample* samples, uint32_t count, uint32_t portion) {
  for (uint32_t at = 0; at < count;) {
    const uint32_t left = count - at;
    const PushResult result = encoder.push(samples + at, left < portion ? left : portion);
    at += result.samples;
    if (result.status != Status::suspended) reference::require_ok(result.status);
  }
}

template <class Call>
void until_done(Call call) {
  Status status = Status::suspended;
  while (status == Status::suspended) status = call();
  reference::require_ok(status);
}

/// Continues the encoder from a checkpoint, in other memory of equal size.
template <class AnyEncoder>
void lose_power(AnyEncoder& encoder, reference::Block& memory, Line& line) {
  Memory parts[2];
  until_done([&] {
    (void)encoder.resume();
    return encoder.save(parts);
  });
  reference::Block restored(memory.memory().bytes);
  std::memcpy(restored.memory().data, parts[1].data, parts[1].bytes);
  reference::require_ok(encoder.restore(restored.memory(), line.output()));
  line.bytes.resize(encoder.bytes());
  memory = std::move(restored);
}

template <class AnyEncoder, class Sample>
Bytes encode_samples(AnyEncoder& encoder, const SliceEncoderConfig& config,
                     const std::vector<Sample>& samples, const SlicePlan& plan) {
  reference::Block block(AnyEncoder::minimum_bytes(config));
  Line line(plan.bytes_at_once);
  reference::require_ok(encoder.start(config, block.memory(), line.output()));
  const uint32_t width = config.limits.width;
  const auto rows = static_cast<uint32_t>(samples.size() / width);
  const uint32_t rows_at_once = plan.flush_every > 0 ? plan.flush_every : rows;
  for (uint32_t row = 0; row < rows; row += rows_at_once) {
    const uint32_t count = std::min(rows_at_once, rows - row);
    push_rows(encoder, &samples[size_t{row} * width], count * width, plan.portion);
    if (plan.flush_every > 0) until_done([&] { return encoder.flush(); });
    if (plan.fails) lose_power(encoder, block, line);
  }
  until_done([&] { return encoder.finish(); });
  if (encoder.bytes() != line.bytes.size()) throw std::runtime_error("bytes() is wrong");
  if (!block.is_intact()) throw std::runtime_error("a write outside the memory");
  return line.bytes;
}

inline Bytes encode_slices(const reference::BitVolume& volume, const SlicePlan& plan = {}) {
  StreamHeader header = header_of(volume);
  header.surface_count = plan.surface_count;
  for (int32_t& threshold : header.thresholds) threshold = plan.levels == 0 ? 1 : 100;
  SliceEncoderConfig config = slice_config(header, plan.key_slice_interval);
  config.levels = plan.levels;
  if (plan.levels == 0) {
    SliceEncoder encoder;
    return encode_samples(encoder, config, volume.on, plan);
  }
  FractionSliceEncoder<uint8_t> encoder;
  return encode_samples(encoder, config, reference::samples_with(volume).samples, plan);
}

/// Returns a stream that reports all its rows as lost.
inline Bytes lost_slices(const reference::Size& size) {
  Line line;
  detail::stream::PacketWriter packets;
  packets.attach(line.output());
  packets.header() = {size.width, size.height, size.depth, {}, {1}, Border::closed};
  packets.begin_stream(detail::wire::HeaderFlags::slices);
  if (!packets.drain()) throw std::runtime_error("the line must accept all bytes");
  packets.seal_slices_trailer(size.depth, false, uint64_t{size.height} * size.depth, 0);
  if (!packets.drain()) throw std::runtime_error("the line must accept all bytes");
  return line.bytes;
}

struct RecordedRow {
  RowEvent event;
  Bytes bits;
  std::vector<uint16_t> fractions;  ///< of the previous event; or empty

  bool is(RowEvent::Kind kind) const { return event.kind == kind; }
};

struct ReceivedRows {
  std::vector<RecordedRow> rows;
  StreamReport report;
  Status status;
};

/// Records rows. With `refuses`, accepts every event only at its second offer.
class RowLog {
 public:
  explicit RowLog(bool refuses) : refuses_(refuses) {}
  void set_width(uint32_t width) { width_ = width; }
  SinkResult accept(const RowEvent& event) {
    if (event.kind == RowEvent::Kind::start) {
      starts.push_back(*event.header);
      return SinkResult::accepted;
    }
    was_refused_ = refuses_ && !was_refused_;
    if (was_refused_) return SinkResult::busy;
    if (event.kind == RowEvent::Kind::fractions) {
      if (!fractions_.empty()) throw std::runtime_error("fractions without a row");
      fractions_.assign(event.fractions, event.fractions + width_);
      fractions_event_ = event;
      return SinkResult::accepted;
    }
    if (!fractions_.empty() && !is_of_fractions_row(event))
      throw std::runtime_error("fractions of another row");
    Bytes bits;
    if (event.kind == RowEvent::Kind::row || event.kind == RowEvent::Kind::skipped)
      for (uint32_t x = 0; x < width_; ++x) bits.push_back(event.bits[x / 8] >> x % 8 & 1);
    rows.push_back({event, bits, fractions_});
    fractions_.clear();
    return SinkResult::accepted;
  }

  std::vector<RecordedRow> rows;
  std::vector<StreamHeader> starts;

 private:
  bool is_of_fractions_row(const RowEvent& event) const {
    return event.kind == RowEvent::Kind::row && event.slice == fractions_event_.slice &&
           event.row == fractions_event_.row && event.channel == fractions_event_.channel;
  }

  bool refuses_;
  bool was_refused_ = false;
  uint32_t width_ = 0;
  std::vector<uint16_t> fractions_;  // of the next row
  RowEvent fractions_event_{};
};

/// Pushes all bytes of a stream in portions (0: all at once), and ends the stream. Returns the
/// first error, or ok.
template <class Decoding>
Status push_stream(Decoding& decoder, const Bytes& bytes, size_t chunk) {
  for (size_t at = 0; at < bytes.size();) {
    const size_t left = bytes.size() - at;
    const Decoded decoded =
        decoder.push(bytes.data() + at, chunk == 0 || chunk > left ? left : chunk);
    at += decoded.bytes;
    if (decoded.status == Status::finished && at == bytes.size()) break;  // for a Receiver
    if (decoded.status != Status::ok && decoded.status != Status::suspended) return decoded.status;
  }
  until_done([&] { return decoder.finish(); });
  return Status::ok;
}

/// Pushes all bytes of a stream, without an end, and repeats while the sink is busy. Returns the
/// number of accepted bytes.
template <class Decoding>
size_t push_until_done(Decoding& decoder, const Bytes& bytes) {
  size_t consumed = 0;
  until_done([&] {
    const Decoded decoded = decoder.push(bytes.data() + consumed, bytes.size() - consumed);
    consumed += decoded.bytes;
    return decoded.status;
  });
  return consumed;
}

/// Decodes in portions (0: all at once). Limit: the slices have the given size; larger slices
/// return too_little_memory.
inline ReceivedRows decode_slices(const Bytes& bytes, const reference::Size& size, size_t chunk = 0,
                                  bool refuses = false, uint32_t surfaces = 1,
                                  uint32_t levels = 0) {
  reference::Block block(SliceDecoder::minimum_bytes({size.width, size.height}, surfaces, levels));
  RowLog log(refuses);
  log.set_width(size.width);
  SliceDecoder decoder;
  reference::require_ok(decoder.start(block.memory(), make_row_sink(log)));
  const Status status = push_stream(decoder, bytes, chunk);
  if (!block.is_intact()) throw std::runtime_error("a write outside the memory");
  return {log.rows, decoder.report(), status};
}

/// Decodes the surface of a stream of either kind, in ample memory.
inline Received decode_surface(const Bytes& stream, const Limits& limits, size_t chunk = 0,
                               bool refuses = false, uint8_t channel = any_channel) {
  EventLog log(refuses ? EventLog::Refuses(reference::refuses_first) : nullptr);
  reference::Block block(Receiver::minimum_bytes(limits) + 200000);
  SurfaceDecoder decoder;
  reference::require_ok(decoder.start(block.memory(), make_sink(log), channel));
  const Status status = push_stream(decoder, stream, chunk);
  if (!block.is_intact()) throw std::runtime_error("a write outside the memory");
  return {log.events, decoder.report(), decoder.header(), status};
}

/// Returns the voxels of a surface, row after row.
inline Bytes voxels_of(const std::vector<RecordedRow>& rows, uint8_t channel) {
  Bytes voxels;
  for (const RecordedRow& row : rows)
    if (row.event.channel == channel) voxels.insert(voxels.end(), row.bits.begin(), row.bits.end());
  return voxels;
}

/// Whether the rows of the first surface have the fractions of these samples. Edges to a skipped
/// row have none, and neither have edges to the slice before a loss.
template <class Sample>
bool have_fractions(const std::vector<RecordedRow>& rows,
                    const reference::SampleVolume<Sample>& volume, int32_t threshold,
                    uint32_t levels, uint8_t channel = 0) {
  std::vector<bool> has_arrived(size_t{volume.size.height} * volume.size.depth);
  for (const RecordedRow& row : rows) {
    if (row.is(RowEvent::Kind::lost)) has_arrived.assign(has_arrived.size(), false);
    if (!row.is(RowEvent::Kind::row) || row.event.channel != channel) continue;
    const uint32_t y = row.event.row, z = row.event.slice;
    const size_t at = size_t{z} * volume.size.height + y;
    has_arrived[at] = true;
    std::vector<uint16_t> expected = reference::fractions_of_row(volume, threshold, levels, y, z);
    bool has_entries = false;
    for (uint16_t& entry : expected) {
      if (y > 0 && !has_arrived[at - 1]) entry &= 0707;
      if (z > 0 && !has_arrived[at - volume.size.height]) entry &= 0077;
      has_entries = has_entries || entry != 0;
    }
    if (has_entries ? row.fractions != expected : !row.fractions.empty()) return false;
  }
  return true;
}

}  // namespace discmc::test
