// A whole stream of regions, read as WIRE.md specifies: slowly, and without a line of the library.
// A mistake that its encoder and its decoder share shows here.
#ifndef DISCMC_TESTS_ORACLE_RECORD_READER_HPP
#define DISCMC_TESTS_ORACLE_RECORD_READER_HPP

#include <algorithm>
#include <array>
#include <cstdint>
#include <fstream>
#include <iterator>
#include <sstream>
#include <string>
#include <vector>

#include "slice_reader.hpp"

namespace discmc::reference {

/// What a stream holds, each as its numbers:
///   "region" code, "ring" x y z, "run" direction length, "region end",
///   "fragment" code came x y z, "fragment end", "layer" slice, "skipped" slice row repeated.
struct RecordRead {
  std::string kind;
  std::vector<int64_t> numbers;
  bool operator==(const RecordRead& other) const {
    return kind == other.kind && numbers == other.numbers;
  }
};

class RecordReader {
 public:
  /// The texts of WIRE.md, for the table of directions, and of shares.cpp.
  RecordReader(const std::string& document, const std::string& source) {
    read_directions(document);
    read_shares(source);
  }

  /// Errors: throws where the stream is not whole, or not as WIRE.md specifies.
  std::vector<RecordRead> read(const std::vector<uint8_t>& stream) {
    records_.clear();
    for (const PacketRead& packet : packets_in(stream))
      if (packet.kind == 2 || packet.kind == 7) read_packet(packet.payload);
    return records_;
  }

 private:
  using Vector = std::array<int64_t, 3>;

  // ---- the tables ----

  void read_directions(const std::string& document) {
    std::istringstream text(document.substr(document.find("| code | normal |")));
    std::string line;
    std::getline(text, line);
    std::getline(text, line);
    while (std::getline(text, line) && !line.empty()) {
      std::replace_if(
          line.begin(), line.end(), [](char c) { return c == '|' || c == ','; }, ' ');
      std::istringstream numbers(line);
      size_t code = 0;
      numbers >> code;
      for (int64_t& component : normal_.at(code)) numbers >> component;
      for (Vector v; numbers >> v[0] >> v[1] >> v[2];) directions_[code].push_back(v);
    }
  }

  void read_shares(const std::string& source) {
    std::string list = source.substr(source.find("= {") + 3);
    list.resize(list.find('}'));
    std::replace(list.begin(), list.end(), ',', ' ');
    std::istringstream numbers(list);
    for (uint32_t below = 0; numbers >> below;) shares_.push_back(below);
    require_as_told(shares_.size() == 556, "the table of shares");
  }

  // ---- section 6 ----

  void begin_code(const std::vector<uint8_t>& payload) {
    payload_ = payload;
    at_ = 0;
    range_ = 0xFFFFFFFF;
    code_ = 0;
    for (int i = 0; i < 4; ++i) code_ = code_ * 256 + next_byte();
  }
  uint64_t next_byte() {
    require_as_told(at_ < payload_.size() + 4, "the end of a code");
    const uint64_t byte = at_ < payload_.size() ? payload_[at_] : 0;
    ++at_;
    return byte;
  }
  void refill() {
    for (; range_ < 1 << 24; range_ *= 256) code_ = code_ * 256 + next_byte();
  }
  // Row number `row` of a table that begins at `first`, with a number of symbols per row.
  uint64_t symbol(uint64_t first, uint64_t symbols, uint64_t row = 0) {
    const uint64_t unit = range_ / 256;
    for (uint64_t s = symbols; s-- > 0;) {
      const uint64_t at = first + row * symbols + s;
      const uint64_t below = s > 0 && shares_.at(at) == 0 ? 256 : shares_[at];
      const uint64_t end = shares_.at(at + 1) == 0 ? 256 : shares_[at + 1];
      if (below == end || code_ < unit * below) continue;
      code_ -= unit * below;
      range_ = unit * (end - below);
      require_as_told(code_ < range_, "the symbols of a code");
      refill();
      return s;
    }
    throw std::runtime_error("a row without a symbol");
  }
  uint64_t even(uint64_t bits) {
    if (bits > 8) {
      const uint64_t high = even(8);
      return high << (bits - 8) | even(bits - 8);
    }
    range_ >>= bits;
    const uint64_t value = code_ / range_;
    require_as_told(value >> bits == 0, "even bits");
    code_ -= value * range_;
    refill();
    return value;
  }

  // ---- section 7 ----

  uint64_t number(uint64_t first, uint64_t row = 0) {
    const uint64_t s = symbol(first, 11, row);
    if (s < 3) return s + 1;
    const uint64_t k = s < 10 ? s - 1 : even(5) + 1;
    return ((uint64_t{1} << k) + even(k)) & 0xFFFFFFFF;
  }
  int64_t signed_number(uint64_t first, uint64_t row = 0) {
    const auto m = static_cast<int64_t>(number(first, row)) - 1;
    return m % 2 == 0 ? m / 2 : -(m + 1) / 2;
  }
  uint64_t plain() { return number(339) - 1; }

  // ---- section 8: the rows of the class ----

  uint64_t n() const { return directions_[incidence_].size(); }
  uint64_t link_class() const { return n() / 2 - 2; }
  uint64_t of_class(std::array<uint64_t, 3> from) const { return from[link_class()]; }
  uint64_t level() const { return directions_[incidence_][direction_][2] == 0 ? 1 : 0; }
  uint64_t kind_of_link() const {
    return link_class() == 2 && direction_ % 2 == 0 ? 3 : link_class();
  }

  // ---- section 9 ----

  void note(const std::string& kind, const std::vector<int64_t>& numbers = {}) {
    records_.push_back({kind, numbers});
  }

  void read_packet(const std::vector<uint8_t>& payload) {
    begin_code(payload);
    vertex_ = {0, 0, 0};
    axis_ = 0;
    incidence_ = 13;
    slice_ = 0;
    uint64_t fragments = 0;
    for (;;) {
      const uint64_t kind = symbol(0, 9, fragments);
      if (kind == 2 || kind == 3)
        fragments = 2;
      else if (fragments == 2)
        fragments = 1;
      if (kind == 6) return;
      if (kind < 2) read_region(kind == 1);
      if (kind == 2 || kind == 3) read_fragment(kind == 3);
      if (kind == 4) {
        slice_ = (slice_ + plain()) & 0xFFFFFFFF;
        note("layer", {static_cast<int64_t>(slice_)});
      }
      if (kind == 5) read_part();
      if (kind == 7) {
        const auto slice = static_cast<int64_t>(plain());
        const auto row = static_cast<int64_t>(plain());
        note("skipped", {slice, row, static_cast<int64_t>(even(1))});
      }
      if (kind == 8) {
        even(8);
        for (uint64_t count = even(8); count > 0; --count) even(8);
      }
    }
  }

  Vector read_vertex() {
    place_ = symbol(27, 13);
    int64_t dx = 0, dy = 0, dz = 0;
    if (place_ < 8) dx = static_cast<int64_t>(place_);
    if (place_ == 8) dx = 7 + static_cast<int64_t>(number(72, 0));
    if (place_ == 9) dx = -static_cast<int64_t>(number(72, 1));
    if (place_ == 10) dy = 1;
    if (place_ == 11) dy = -1;
    if (place_ == 12) dz = signed_number(138);
    if (place_ == 12) dy = signed_number(127);
    if (place_ > 9) dx = signed_number(72, place_ - 8);
    axis_before_ = axis_;
    axis_ = symbol(40, 4, axis_before_ + (place_ == 0 ? 0 : 4));
    const Vector way{dx, dy, dz};
    for (uint64_t i = 0; i < 3; ++i)
      vertex_[i] = static_cast<int32_t>(2 * ((vertex_[i] >> 1) + way[i]) +
                                        (axis_ == i || axis_ == 3 ? 1 : 0));
    return vertex_;
  }

  static uint64_t heading_of(const Vector& normal, uint64_t axis) {
    const uint64_t first = axis == 0 ? 1 : 0, second = axis == 2 ? 1 : 2;
    return static_cast<uint64_t>(1 + normal[first] + 3 * (1 + normal[second]));
  }

  void read_incidence() {
    uint64_t s = 9;
    int64_t sign = 0;
    if (axis_ < 3) {
      if (place_ == 0 && axis_before_ < 3) sign = normal_[incidence_][axis_before_];
      if (sign == 0) sign = even(1) == 0 ? -1 : 1;
      const uint64_t before = heading_of(normal_[incidence_], axis_);
      s = symbol(149, 10, sign < 0 ? 8 - before : before);
    }
    if (s == 9) {
      incidence_ = even(5);
    } else {
      const auto has = [&](const Vector& normal) {
        return normal[axis_] == sign && heading_of(normal, axis_) == (sign < 0 ? 8 - s : s);
      };
      incidence_ = static_cast<uint64_t>(std::find_if(normal_.begin(), normal_.end(), has) -
                                         normal_.begin());
    }
    require_as_told(incidence_ < 27 && incidence_ != 13, "an incidence");
  }

  void turn(uint64_t by) { direction_ = (direction_ + (is_backwards_ ? n() - by : by)) % n(); }
  void add_run(int64_t length) {
    require_as_told(length >= 1, "the length of a run");
    runs_.push_back({static_cast<int64_t>(direction_), length});
  }

  void read_runs(uint64_t chain) {
    runs_.clear();
    add_run(static_cast<int64_t>(number(239, kind_of_link())));
    while (symbol(327, 2, 2 * chain + level()) == 0) {
      const uint64_t s =
          symbol(of_class({382, 430, 495}), 2 * n(), link_class() == 2 ? direction_ % 2 : 0);
      turn(s / 2);
      add_run(s % 2 == 0 ? 1 : 1 + static_cast<int64_t>(number(283, kind_of_link())));
    }
  }
  void note_runs() {
    for (const std::array<int64_t, 2>& run : runs_) note("run", {run[0], run[1]});
  }
  void first_direction() { direction_ = symbol(of_class({378, 424, 487}), n()); }
  void cut_turn() { turn(symbol(of_class({370, 412, 471}), n(), level())); }

  void read_region(bool has_holes) {
    is_backwards_ = false;
    uint64_t rings = 1;
    for (uint64_t ring = 0; ring < rings; ++ring) {
      const Vector start = read_vertex();
      if (ring == 0) {
        read_incidence();
        if (has_holes) rings = 2 + plain();
        note("region", {static_cast<int64_t>(incidence_)});
      }
      note("ring", {start[0], start[1], start[2]});
      read_ring();
      note_runs();
    }
    note("region end");
  }

  bool leads_back(uint64_t direction) const {
    const Vector& v = directions_[incidence_][direction];
    return v[2] < 0 || (v[2] == 0 && (v[1] < 0 || (v[1] == 0 && v[0] < 0)));
  }

  void read_ring() {
    const uint64_t corners = symbol(of_class({390, 442, 527}), of_class({2, 9, 28}));
    uint64_t f = symbol(of_class({350, 392, 451}), 4);
    if (f == 3) f = even(3);
    require_as_told(f < n(), "the first direction of a ring");
    uint64_t b = n() / 2;
    while (b < n() && !leads_back(b)) ++b;
    direction_ = (b + f) % n();
    if (corners > 0) {
      read_corners(corners - 1);
    } else {
      read_runs(2);
      const Vector way = way_back();
      for (direction_ = 0; links_to(way, direction_) == 0;) {
        ++direction_;
        require_as_told(direction_ < n(), "the last run of a ring");
      }
      add_run(links_to(way, direction_));
    }
  }

  void read_corners(uint64_t code) {
    const uint64_t m = n() / 2 - 1;
    const uint64_t turns[] = {1 + code % m, 1 + code / m % m, 1 + code / m / m};
    std::vector<uint64_t> way{direction_};
    for (const uint64_t by : turns) way.push_back((way.back() + by) % n());
    const bool are_three = turns[0] + turns[1] + turns[2] == n();
    runs_.clear();
    if (are_three) {
      add_run(static_cast<int64_t>(number(239, kind_of_link())));
    } else {
      const uint64_t t = symbol(of_class({354, 396, 455}), 16);
      for (const uint64_t length : {1 + t / 4, 1 + t % 4}) {
        direction_ = way[runs_.size()];
        add_run(static_cast<int64_t>(length == 4 ? 3 + number(283, kind_of_link()) : length));
      }
    }
    // Either length decides the other: all of one of them are tried.
    const uint64_t u = way[runs_.size()], v = way[runs_.size() + 1];
    for (int64_t p = 1; p <= 65535; ++p) {
      Vector left = way_back();
      go(left, static_cast<int64_t>(u), -p);
      const int64_t q = links_to(left, v);
      if (q == 0) continue;
      runs_.push_back({static_cast<int64_t>(u), p});
      runs_.push_back({static_cast<int64_t>(v), q});
      return;
    }
    throw std::runtime_error("corners that do not close");
  }

  Vector way_back() const {
    Vector way{0, 0, 0};
    for (const std::array<int64_t, 2>& run : runs_) go(way, run[0], -run[1]);
    return way;
  }
  // How many links along a direction go this way; 0 where none to 65,535 do.
  int64_t links_to(const Vector& way, uint64_t direction) const {
    const Vector& v = directions_[incidence_][direction];
    for (size_t i = 0; i < 3; ++i) {
      if (v[i] == 0) continue;
      const int64_t links = way[i] / v[i];
      const bool leads_there = way == Vector{links * v[0], links * v[1], links * v[2]};
      return leads_there && links >= 1 && links <= 65535 ? links : 0;
    }
    return 0;
  }

  void read_fragment(bool is_backwards) {
    is_backwards_ = is_backwards;
    Vector start = read_vertex();
    read_incidence();
    first_direction();
    auto came = static_cast<int64_t>(direction_);
    if (!is_backwards) cut_turn();
    read_runs(is_backwards ? 1 : 0);
    if (is_backwards) {
      cut_turn();
      came = static_cast<int64_t>(direction_);
      for (size_t i = 0; i < runs_.size(); ++i)
        go(start, runs_[i][0], i == 0 ? 1 - runs_[i][1] : -runs_[i][1]);
      std::reverse(runs_.begin(), runs_.end());
    }
    note("fragment", {static_cast<int64_t>(incidence_), came, start[0], start[1], start[2]});
    note_runs();
    note("fragment end");
  }
  void go(Vector& vertex, int64_t direction, int64_t links) const {
    for (size_t i = 0; i < 3; ++i)
      vertex[i] = static_cast<int32_t>(
          vertex[i] + links * directions_[incidence_][static_cast<size_t>(direction)][i]);
  }

  void read_part() {
    is_backwards_ = false;
    const uint64_t flags = even(4);
    const bool is_fragment = (flags & 8) != 0, goes_on = (flags & 4) != 0;
    const bool begins_ring = (flags & 1) != 0;
    incidence_ = even(5);
    require_as_told(incidence_ < 27 && incidence_ != 13, "the incidence of a part");
    require_as_told(goes_on ? !(begins_ring && is_fragment) : begins_ring, "the ring of a part");
    Vector start{};
    if (begins_ring) start = read_vertex();
    first_direction();
    const auto came = static_cast<int64_t>(direction_);
    if (is_fragment && !goes_on) cut_turn();
    read_runs(0);
    const auto code = static_cast<int64_t>(incidence_);
    if (is_fragment && !goes_on) note("fragment", {code, came, start[0], start[1], start[2]});
    if (!is_fragment && !goes_on) note("region", {code});
    if (!is_fragment && begins_ring) note("ring", {start[0], start[1], start[2]});
    note_runs();
    if ((flags & 2) != 0) note(is_fragment ? "fragment end" : "region end");
  }

  std::array<Vector, 27> normal_{};
  std::array<std::vector<Vector>, 27> directions_;
  std::vector<uint64_t> shares_;

  std::vector<uint8_t> payload_;
  size_t at_ = 0;
  uint64_t code_ = 0;
  uint64_t range_ = 0;

  Vector vertex_{};
  uint64_t place_ = 0;
  uint64_t axis_ = 0;
  uint64_t axis_before_ = 0;
  uint64_t incidence_ = 13;
  uint64_t slice_ = 0;
  uint64_t direction_ = 0;
  bool is_backwards_ = false;
  std::vector<std::array<int64_t, 2>> runs_;
  std::vector<RecordRead> records_;
};

/// source: the folder of the project.
inline std::vector<RecordRead> read_records(const std::vector<uint8_t>& stream,
                                            const std::string& source) {
  const auto text = [&](const char* name) {
    std::ifstream file(source + name);
    require_as_told(file.is_open(), "where the tables are");
    return std::string{std::istreambuf_iterator<char>(file), {}};
  };
  return RecordReader(text("/lib/WIRE.md"), text("/lib/discmc/stream/shares.cpp")).read(stream);
}

}  // namespace discmc::reference

#endif
