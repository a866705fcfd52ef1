// A record of the stream, before encoding or after decoding.
#ifndef DISCMC_STREAM_RECORD_HPP
#define DISCMC_STREAM_RECORD_HPP

#include <discmc/chain.hpp>

namespace discmc::detail::stream {

/// A region, a loose fragment, or a part of one: the unit of encoding. One list of words contains
/// rings and runs. A zero word begins a ring, and its start (x, y, z) follows; any other word is
/// the code of a Run. Runs before the first ring continue the previous part. A fragment begins like
/// a ring.
struct Record {
  static constexpr uint32_t max_words = 96;
  static constexpr uint32_t ring_mark = 0;
  static constexpr uint32_t ring_words = 4;

  Incidence incidence = 0;
  Direction incoming = 0;  ///< to the start of a fragment
  bool is_fragment = false;
  bool continues = false;  ///< not the first part
  bool is_last = false;    ///< no part follows
  uint32_t rings = 0;      ///< begun so far
  uint32_t count = 0;
  uint32_t word[max_words] = {};

  /// Empties the record and makes it the first part of a region.
  void begin(Incidence region_incidence) {
    incidence = region_incidence;
    incoming = 0;
    is_fragment = false;
    continues = false;
    is_last = false;
    rings = 0;
    count = 0;
  }
  /// Makes the record that of a fragment instead.
  void begin_fragment(Direction incoming_by, const Vertex& start) {
    incoming = incoming_by;
    is_fragment = true;
    add_ring(start);
  }

  bool has_room(uint32_t words) const { return count + words <= max_words; }
  void add_run(Run run) { word[count++] = run.code(); }
  void add_ring(const Vertex& start) {
    ++rings;
    word[count] = ring_mark;
    set_start(count, start);
    count += ring_words;
  }
  void set_start(uint32_t mark, const Vertex& start) {
    word[mark + 1] = static_cast<uint32_t>(start.x);
    word[mark + 2] = static_cast<uint32_t>(start.y);
    word[mark + 3] = static_cast<uint32_t>(start.z);
  }
  /// The number of first words that belong to one ring, and so form one part.
  uint32_t words_of_part(uint32_t limit) const {
    uint32_t words = count > 0 && word[0] == ring_mark ? ring_words : 0;
    while (words < limit && word[words] != ring_mark) ++words;
    return words;
  }
  /// Reverses the order of a fragment's runs.
  void reverse_runs() {
    for (uint32_t i = ring_words, j = count; i < j; ++i) {
      const uint32_t last = word[--j];
      word[j] = word[i];
      word[i] = last;
    }
  }
  Vertex start_at(uint32_t mark) const {
    return {static_cast<int32_t>(word[mark + 1]), static_cast<int32_t>(word[mark + 2]),
            static_cast<int32_t>(word[mark + 3])};
  }
};

}  // namespace discmc::detail::stream

#endif
