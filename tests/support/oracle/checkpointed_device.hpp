// A scan that is saved and continues in other memory.
#pragma once

#include <algorithm>
#include <discmc/checkpoint.hpp>
#include <stdexcept>
#include <vector>

#include "scan.hpp"
#include "stream.hpp"
#include "thinned.hpp"
#include "volume.hpp"

namespace discmc::test {

using namespace discmc::reference;

/// The receiver of a stream's bytes: accepts all, or at most max_bytes at a time, with pauses.
struct Store {
  Bytes bytes;
  size_t max_bytes = SIZE_MAX;
  bool pauses = false;

  static size_t write(void* context, const uint8_t* bytes, size_t count) {
    auto& store = *static_cast<Store*>(context);
    const bool accepts = store.max_bytes == SIZE_MAX || (store.pauses = !store.pauses);
    if (!accepts) return 0;
    count = std::min(count, store.max_bytes);
    store.bytes.insert(store.bytes.end(), bytes, bytes + count);
    return count;
  }
  ByteOutput output() {
    return {this, write, [](void*) { return size_t{0}; }};
  }
};

/// The saved state of a device, as one string of bytes, as in flash.
using Image = Bytes;

inline Image image_of(const std::vector<Memory>& parts) {
  Image image;
  for (const Memory& part : parts) {
    const auto* const bytes = static_cast<const uint8_t*>(part.data);
    image.insert(image.end(), bytes, bytes + part.bytes);
  }
  return image;
}
/// Reads the image back; memory beyond its end is unchanged.
inline void read_back(const Image& image, const std::vector<Memory>& parts) {
  const uint8_t* next = image.data();
  const uint8_t* const end = next + image.size();
  for (const Memory& part : parts) {
    const size_t count = std::min(part.bytes, static_cast<size_t>(end - next));
    unpoison(part.data, count);  // as the checkpoint store does
    std::copy_n(next, count, static_cast<uint8_t*>(part.data));
    next += count;
  }
}

/// Continues a scan in another extractor and in other memory.
template <class Scanner>
Status move_scan(Scanner& from, Scanner& to, Memory memory, const Sink& sink) {
  Memory parts[2];
  const Status status = from.save(parts);
  if (status != Status::ok) return status;
  read_back(image_of({parts, parts + 2}), {memory_of(to), memory});
  return to.restore(memory, sink);
}

/// Returns the first bit of an image whose flip the device does not detect, or the number of bits.
template <class AnyDevice>
size_t first_unnoticed_flip(const Image& image, AnyDevice& device) {
  for (size_t bit = 0; bit < 8 * image.size(); bit += reference::step(7)) {
    Image flipped = image;
    flipped[bit / 8] = static_cast<uint8_t>(flipped[bit / 8] ^ 1 << bit % 8);
    if (device.restore(flipped) != Status::bad_checkpoint) return bit;
  }
  return 8 * image.size();
}

/// A device with an extractor and an encoder, in memory of its own, and its checkpoints.
template <class Index>
class Device {
 public:
  Device(const BitVolume& volume, Border border, uint64_t bytes)
      : volume_(volume), limits_(limits_of(volume, border)), block_(bytes) {}

  void start() {
    require_ok(encoder_.start({volume_.depth}, store.output()));
    require_ok(extractor_.start(limits_, 1, block_.memory(), make_sink(encoder_)));
  }

  /// Pushes rows up to a row number, counted through all slices.
  void scan_to(uint32_t end) {
    uint32_t row = extractor_.slices() * volume_.height + extractor_.rows();
    for (; row < end; ++row) {
      Status status =
          extractor_.push(&volume_.on[size_t{row} * volume_.width], volume_.width).status;
      while (status == Status::suspended) status = extractor_.resume();
      require_ok(status);
    }
  }
  void finish() {
    scan_to(rows());
    finish_all(extractor_);
    if (!block_.is_intact()) throw std::runtime_error("a write outside the arena");
  }
  uint32_t rows() const { return volume_.height * volume_.depth; }

  /// The parts of a checkpoint.
  std::vector<Memory> save_parts() {
    std::vector<Memory> parts(3);
    require_ok(encoder_.save(&parts[0]));
    require_ok(extractor_.save(&parts[1]));
    return parts;
  }
  /// Returns the memory for reading the parts back.
  std::vector<Memory> parts() {
    return {memory_of(encoder_), memory_of(extractor_), block_.memory()};
  }
  Status restore_parts() {
    const Status status = encoder_.restore(store.output());
    if (status != Status::ok) return status;
    return extractor_.restore(block_.memory(), make_sink(encoder_));
  }

  Image save() { return image_of(save_parts()); }
  Status restore(const Image& image) {
    read_back(image, parts());
    return restore_parts();
  }

  /// Returns the number of bytes of the stream so far.
  uint64_t position() const { return encoder_.bytes(); }

  Store store;

 private:
  BitVolume volume_;
  Limits limits_;
  Block block_;
  Extractor<Index> extractor_;
  Encoder encoder_;
};

inline BitVolume centred_ball(uint32_t size) {
  const auto middle = static_cast<int32_t>(size - 1);
  return ball({size, size, size}, {middle, middle, middle}, middle * middle / 4);
}

struct Scan {
  const char* name;
  BitVolume volume;
  Border border;
  uint64_t spare;  // bytes beyond the minimum
};

inline std::vector<Scan> scans() {
  return {{"a ball", centred_ball(9), Border::closed, 1 << 16},
          {"a ball in too little memory", centred_ball(9), Border::open, 200},
          {"noise", random({7, 5, 6}, 128, 1), Border::open, 1 << 16},
          {"noise in too little memory", random({7, 5, 6}, 128, 2), Border::closed, 300}};
}

template <class Index>
Device<Index> device_for(const Scan& scan) {
  const uint64_t min_bytes = Extractor<Index>::minimum_bytes(limits_of(scan.volume, scan.border));
  return Device<Index>(scan.volume, scan.border, min_bytes + scan.spare);
}

template <class Index>
Bytes uninterrupted(const Scan& scan) {
  auto device = device_for<Index>(scan);
  device.start();
  device.finish();
  return device.store.bytes;
}

}  // namespace discmc::test
