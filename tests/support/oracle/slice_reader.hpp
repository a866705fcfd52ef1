// A whole stream of slices, read as WIRE.md specifies: slowly, and without a line of the library. A
// mistake that its encoder and its decoder share shows here.
#ifndef DISCMC_TESTS_ORACLE_SLICE_READER_HPP
#define DISCMC_TESTS_ORACLE_SLICE_READER_HPP

#include <array>
#include <cstddef>
#include <cstdint>
#include <fstream>
#include <stdexcept>
#include <string>
#include <vector>

namespace discmc::reference {

inline void require_as_told(bool holds, const char* what) {
  if (!holds) throw std::runtime_error(std::string("not as WIRE.md specifies: ") + what);
}

/// Little-endian fields. Errors: throws beyond the end.
class Fields {
 public:
  explicit Fields(const std::vector<uint8_t>& bytes) : bytes_(bytes) {}
  uint64_t next(int count) {
    uint64_t value = 0;
    for (int i = 0; i < count; ++i) value += uint64_t{bytes_.at(at_++)} << 8 * i;
    return value;
  }

 private:
  const std::vector<uint8_t>& bytes_;
  size_t at_ = 0;
};

// ---- sections 1 and 2: frames and packets ----

struct PacketRead {
  uint8_t kind = 0;
  uint32_t number = 0;  ///< three bytes; of a header the lowest is its number
  std::vector<uint8_t> payload;
  uint32_t scan = 0;
  uint32_t channel = 0;
  uint32_t surfaces = 0;
  uint32_t check = 0;
};

inline std::vector<uint8_t> unstuffed(std::vector<uint8_t> frame) {
  for (size_t at = 0; at < frame.size();) {
    const size_t distance = frame[at];
    require_as_told(distance > 0 && at + distance <= frame.size(), "a distance");
    frame[at] = 0;
    at += distance;
  }
  frame.erase(frame.begin());
  return frame;
}

inline uint32_t check_of(const std::vector<uint8_t>& bytes, size_t count) {
  uint32_t check = 0xFFFFFFFF;
  for (size_t i = 0; i < count; ++i) {
    check ^= bytes[i];
    for (int bit = 0; bit < 8; ++bit) check = (check >> 1) ^ (check % 2 != 0 ? 0xEDB88320 : 0);
  }
  return ~check;
}

inline PacketRead packet_in(const std::vector<uint8_t>& frame) {
  const std::vector<uint8_t> bytes = unstuffed(frame);
  require_as_told(bytes.size() >= 11 && bytes.size() <= 254, "the size of a packet");
  const size_t tail = bytes.size() - 7;
  PacketRead packet;
  Fields head(bytes);
  packet.kind = static_cast<uint8_t>(head.next(1));
  packet.number = static_cast<uint32_t>(head.next(3));
  const auto at = [&bytes](size_t place) { return bytes.begin() + static_cast<ptrdiff_t>(place); };
  packet.payload.assign(at(4), at(tail));
  const std::vector<uint8_t> last(at(tail), bytes.end());
  Fields name(last);
  packet.scan = static_cast<uint32_t>(name.next(2));
  packet.channel = last[2] & 63;
  packet.surfaces = 1 + last[2] / 64U;
  name.next(1);
  packet.check = static_cast<uint32_t>(name.next(4));
  require_as_told(check_of(bytes, bytes.size() - 4) == packet.check, "a CRC-32");
  return packet;
}

inline std::vector<PacketRead> packets_in(const std::vector<uint8_t>& stream) {
  std::vector<PacketRead> packets;
  std::vector<uint8_t> frame;
  for (const uint8_t byte : stream) {
    if (byte != 0) {
      frame.push_back(byte);
    } else if (!frame.empty()) {
      packets.push_back(packet_in(frame));
      frame.clear();
    }
  }
  require_as_told(frame.empty(), "the end of the last frame");
  return packets;
}

// ---- section 6: the range coder, and what is learnt ----

class RangeRead {
 public:
  explicit RangeRead(const std::vector<uint8_t>& bytes) : bytes_(bytes) {
    for (int i = 0; i < 4; ++i) code_ = code_ * 256 + next();
  }
  bool even() { return below((range_ / 256) * 128); }
  bool learnt(uint32_t& p) {
    const bool bit = below((range_ / 65536) * p);
    p = bit ? p + (65535 - p) / 16 : p - p / 16;
    return bit;
  }
  uint32_t even_bits(int count) {
    uint32_t value = 0;
    for (; count > 0; --count) value = 2 * value + (even() ? 1 : 0);
    return value;
  }

 private:
  bool below(uint64_t bound) {
    const bool bit = code_ < bound;
    if (!bit) code_ -= bound;
    range_ = bit ? bound : range_ - bound;
    for (; range_ < 1 << 24; range_ *= 256) code_ = code_ * 256 + next();
    return bit;
  }
  uint8_t next() {
    require_as_told(at_ < bytes_.size() + 4, "the end of a code");
    const uint8_t byte = at_ < bytes_.size() ? bytes_[at_] : 0;
    ++at_;
    return byte;
  }

  const std::vector<uint8_t>& bytes_;
  size_t at_ = 0;
  uint64_t code_ = 0;
  uint64_t range_ = 0xFFFFFFFF;
};

// ---- section 14: slices ----

/// The contents of a stream.
struct SlicesRead {
  uint32_t width = 0;
  uint32_t height = 0;
  uint32_t depth = 0;  ///< as planned
  uint32_t channel = 0;
  uint32_t surfaces = 0;
  uint32_t slices = 0;  ///< of the trailer, as all that follow
  bool is_abandoned = false;
  uint64_t rows = 0;
  uint64_t skipped_rows = 0;
  uint32_t key_codes = 0;   ///< that begin a key slice
  uint32_t long_codes = 0;  ///< codes of several packets
  uint32_t cut_codes = 0;
  std::vector<uint32_t> notes;  ///< of each row: 0 coded, 1 off, 2 copy of the previous row
  /// All coded voxels of each surface, in x, y, z order.
  std::array<std::vector<uint8_t>, 4> on;
};

class SliceReader {
 public:
  /// model: the text of slice_model.cpp, whose two tables are read.
  explicit SliceReader(const std::string& model) {
    size_t at = model.find('{', model.find("trained[2]"));
    const size_t end = model.find("};", at);
    std::vector<uint32_t> numbers;
    while (at < end) {
      if (model.compare(at, 2, "//") == 0) at = model.find('\n', at);
      size_t digits = 0;
      while (model[at + digits] >= '0' && model[at + digits] <= '9') ++digits;
      if (digits > 0) numbers.push_back(static_cast<uint32_t>(std::stoul(model.substr(at))));
      at += digits + 1;
    }
    require_as_told(numbers.size() == 2 * 272, "the tables");
    for (size_t i = 0; i < numbers.size(); ++i) tables_[i / 272][i % 272] = numbers[i];
  }

  /// Errors: throws where the stream is not whole, or not as WIRE.md specifies.
  SlicesRead read(const std::vector<uint8_t>& stream) {
    sent_words_ = SlicesRead{};
    uint32_t digest = 0, number = 0;
    for (const PacketRead& packet : packets_in(stream)) {
      require_as_told(sent_words_.slices == 0, "the last packet");
      if (packet.kind == 1)
        read_header(packet, number);
      else
        require_as_told(packet.number == number % (1 << 24), "the number of a packet");
      require_as_told(packet.surfaces == sent_words_.surfaces, "the surfaces");
      if (packet.kind >= 16 && packet.kind < 32) read_slices(packet);
      if (packet.kind == 4) read_trailer(packet, digest);
      digest = (digest << 1 | digest >> 31) ^ packet.check;
      ++number;
    }
    return sent_words_;
  }

 private:
  struct Code {
    bool is_open = false;
    uint32_t packets = 0;
    std::vector<uint8_t> bytes;
    bool is_cut = false;
    uint32_t cut_row = 0;
    uint32_t cut_left = 0;
  };

  void read_header(const PacketRead& packet, uint32_t number) {
    require_as_told(packet.number == number % 256, "the number and the pieces of a header");
    Fields fields(packet.payload);
    require_as_told(fields.next(4) == 0x01434D44, "magic and version");
    sent_words_.width = static_cast<uint32_t>(fields.next(2));
    sent_words_.height = static_cast<uint32_t>(fields.next(2));
    sent_words_.depth = static_cast<uint32_t>(fields.next(4));
    fields.next(4), fields.next(4), fields.next(4), fields.next(4);  // spacing, threshold
    require_as_told((fields.next(1) & 2) != 0, "the flag of slices");
    require_as_told(fields.next(4) == number, "the packets of a header");
    require_as_told(fields.next(8) == 0, "the pieces of a header");
    sent_words_.channel = packet.channel;
    sent_words_.surfaces = packet.surfaces;
    for (uint32_t surface = 1; surface < sent_words_.surfaces; ++surface) fields.next(4);
  }

  void read_trailer(const PacketRead& packet, uint32_t digest) {
    require_as_told(!code_.is_open && !is_in_row_, "a trailer within a code");
    Fields fields(packet.payload);
    sent_words_.slices = static_cast<uint32_t>(fields.next(4));
    sent_words_.is_abandoned = fields.next(1) != 0;
    sent_words_.rows = fields.next(8);
    sent_words_.skipped_rows = fields.next(8);
    require_as_told(fields.next(4) == digest, "the digest");
    require_as_told(sent_words_.rows == sent_words_.notes.size(), "the rows of the trailer");
  }

  void read_slices(const PacketRead& packet) {
    std::vector<uint8_t> bytes = packet.payload;
    if ((packet.kind & 2) != 0) {
      require_as_told(!code_.is_open, "a code within another");
      code_ = Code{};
      code_.is_open = true;
    }
    require_as_told(code_.is_open, "a packet of no code");
    if ((packet.kind & 1) != 0) begin_key_slice(bytes);
    if ((packet.kind & 8) != 0) {
      const std::vector<uint8_t> end(bytes.end() - 6, bytes.end());
      Fields place(end);
      code_.is_cut = true;
      code_.cut_row = static_cast<uint32_t>(place.next(4));
      code_.cut_left = static_cast<uint32_t>(place.next(2));
      bytes.resize(bytes.size() - 6);
    }
    code_.bytes.insert(code_.bytes.end(), bytes.begin(), bytes.end());
    ++code_.packets;
    if ((packet.kind & 4) == 0) return;
    read_code();
    code_.is_open = false;
    if (code_.packets > 1) ++sent_words_.long_codes;
    if (code_.is_cut) ++sent_words_.cut_codes;
  }

  void begin_key_slice(std::vector<uint8_t>& bytes) {
    require_as_told(code_.packets == 0 && !is_in_row_ && row() == 0, "where a key slice begins");
    require_as_told(Fields(bytes).next(4) == slice(), "the number of a key slice");
    bytes.erase(bytes.begin(), bytes.begin() + 4);
    is_key_ = true;
    is_first_of_key_ = true;
    begin_contexts();
    ++sent_words_.key_codes;
  }

  // Where the next row is.
  uint32_t slice() const {
    return static_cast<uint32_t>(sent_words_.notes.size() / sent_words_.height);
  }
  uint32_t row() const {
    return static_cast<uint32_t>(sent_words_.notes.size() % sent_words_.height);
  }

  void begin_contexts() {
    const std::array<uint32_t, 272>& table = tables_[is_key_ ? 0 : 1];
    for (std::vector<uint32_t>& p : p_) {
      p.assign(1, 32);
      for (const uint32_t trained : table) p.push_back(256 * trained + 128);
      // Those of voxels once more, for where the first surface differs.
      for (size_t i = 16; i < table.size(); ++i) p.push_back(256 * table[i] + 128);
    }
  }

  void read_code() {
    RangeRead range(code_.bytes);
    for (;;) {
      if (!is_in_row_) {
        const uint32_t note = range.learnt(p_[0][0]) ? 1 + range.even_bits(3) : 0;
        require_as_told(note <= 3, "a note");
        if (note == 1) return;
        begin_row(note == 0 ? 0 : note - 1);
      }
      for (; surface_ < sent_words_.surfaces; ++surface_, x_ = 0)
        while (x_ < sent_words_.width) {
          if (is_at_cut()) return;
          read_step(range);
        }
      sent_words_.notes.push_back(note_);
      is_in_row_ = false;
    }
  }

  // Where it never came it is complete.
  void begin_row(uint32_t note) {
    if (row() == 0 && !is_first_of_key_ && is_key_) {
      is_key_ = false;
      begin_contexts();
    }
    require_as_told(note != 2 || !is_first_of_key_, "what stands in at the start of a key slice");
    is_first_of_key_ = false;
    is_in_row_ = true;
    note_ = note;
    x_ = 0;
    surface_ = note == 0 ? 0 : sent_words_.surfaces;
    for (uint32_t surface = 0; surface < sent_words_.surfaces; ++surface) {
      std::vector<uint8_t>& on = sent_words_.on[surface];
      const size_t before = on.size() - sent_words_.width;
      for (uint32_t x = 0; x < sent_words_.width; ++x) on.push_back(note == 2 ? on[before + x] : 0);
    }
  }

  bool is_at_cut() const {
    const uint64_t rows_before = sent_words_.notes.size() * sent_words_.surfaces + surface_;
    return code_.is_cut && static_cast<uint32_t>(rows_before) == code_.cut_row &&
           sent_words_.width - x_ == code_.cut_left;
  }

  // A voxel of the row that is read, or of one before; of what lies outside the slice, 0.
  uint8_t voxel(uint32_t surface, int64_t z, int64_t y, int64_t x) const {
    if (z < 0 || y < 0 || y >= sent_words_.height || x < 0 || x >= sent_words_.width) return 0;
    return sent_words_
        .on[surface][static_cast<size_t>((z * sent_words_.height + y) * sent_words_.width + x)];
  }

  uint32_t neighbours(int64_t x, uint8_t before) const {
    const int64_t z = slice(), y = row();
    std::array<uint8_t, 8> of{};
    for (size_t i = 0; i < 3; ++i) {
      const int64_t beside = x - 1 + static_cast<int64_t>(i);
      of[i] = voxel(surface_, z, y - 1, beside);
      of[3 + i] = is_key_ ? voxel(surface_, z, y - 2, beside) : voxel(surface_, z - 1, y, beside);
    }
    of[6] = is_key_ ? voxel(surface_, z, y - 3, x) : voxel(surface_, z - 1, y + 1, x);
    of[7] = is_key_ ? voxel(surface_, z, y - 1, x) : voxel(surface_, z - 1, y - 1, x);
    uint32_t differing = 0;
    for (size_t i = 0; i < of.size(); ++i) differing += (of[i] != before ? 1U : 0U) << i;
    return differing;
  }

  void write(uint32_t count, uint8_t value) {
    std::vector<uint8_t>& on = sent_words_.on[surface_];
    for (; count > 0; --count) on[sent_words_.notes.size() * sent_words_.width + x_++] = value;
  }

  void read_step(RangeRead& range) {
    std::vector<uint32_t>& p = p_[surface_];
    const uint8_t before = voxel(surface_, slice(), row(), int64_t{x_} - 1);
    const uint32_t left = sent_words_.width - x_;
    uint32_t n = 0;
    while (n < left && neighbours(x_ + n, before) == 0) ++n;
    if (n < 2) {
      uint32_t differing = neighbours(x_, before);
      if (surface_ > 0 && voxel(0, slice(), row(), x_) != before) differing += 256;
      const bool differs = range.learnt(p.at(17 + differing));
      write(1, differs ? 1 - before : before);
      return;
    }
    int bits_of_n = 0, bits_of_m = 0;
    while (n >> bits_of_n != 0) ++bits_of_n;
    while ((n - 1) >> bits_of_m != 0) ++bits_of_m;
    const uint32_t l = bits_of_n < 8 ? static_cast<uint32_t>(bits_of_n) : 8;
    if (range.learnt(p.at(1 + 2 * (l - 1) + (n == left ? 1 : 0)))) return write(n, before);
    const uint32_t m = range.even_bits(bits_of_m);
    require_as_told(m < n, "a run");
    write(m, before);
    write(1, 1 - before);
  }

  std::array<std::array<uint32_t, 272>, 2> tables_{};
  std::array<std::vector<uint32_t>, 4> p_;
  SlicesRead sent_words_;
  Code code_;
  bool is_key_ = false;           // the slice that is read
  bool is_first_of_key_ = false;  // the row that comes next
  bool is_in_row_ = false;
  uint32_t note_ = 0;
  uint32_t surface_ = 0;
  uint32_t x_ = 0;
};

/// The rows of a whole stream. source: the folder that the library is in. Errors: as
/// SliceReader::read().
inline SlicesRead read_slices(const std::vector<uint8_t>& stream, const std::string& source) {
  std::ifstream file(source + "/lib/discmc/slices/slice_model.cpp");
  require_as_told(file.is_open(), "where the tables are");
  const std::string model{std::istreambuf_iterator<char>(file), {}};
  return SliceReader(model).read(stream);
}

}  // namespace discmc::reference

#endif
