// Regions and loose fragments as 32-bit words: small enough to keep many of them.
#ifndef DISCMC_MESH_SURFACE_EVENT_WORDS_HPP
#define DISCMC_MESH_SURFACE_EVENT_WORDS_HPP

#include <cstddef>
#include <cstdint>
#include <vector>

#include <discmc/sink.hpp>

namespace discmc::meshing {

/// Appends an event: a run takes a word, two with a normal; what has a vertex takes four; else one.
/// Stores only the kind of `start`, `application` and `finish`.
void append_words(const Event& event, std::vector<std::uint32_t>& words);

/// Reads events from words again, one after another.
class EventWords {
 public:
  /// words: Owner: the caller, as long as they are read.
  explicit EventWords(const std::vector<std::uint32_t>& words) : words_(words) {}

  /// Whether there was one more, which is in `event` then.
  bool next(Event& event);

 private:
  const std::vector<std::uint32_t>& words_;
  std::size_t at_ = 0;
};

}  // namespace discmc::meshing

#endif
