// Regions and loose fragments as 32-bit words, so that many fit in memory.
#ifndef DISCMC_MESH_SURFACE_EVENT_WORDS_HPP
#define DISCMC_MESH_SURFACE_EVENT_WORDS_HPP

#include <cstddef>
#include <cstdint>
#include <vector>

#include <discmc/sink.hpp>

namespace discmc::meshing {

/// Appends an event: four words with a vertex, two for a run with a normal, else one. Stores only
/// the kind of `start`, `application` and `finish`.
void append_words(const Event& event, std::vector<std::uint32_t>& words);

/// Reads events back from words.
class EventWords {
 public:
  /// Owner: the caller, of the words, while events are read.
  explicit EventWords(const std::vector<std::uint32_t>& words) : words_(words) {}

  /// Reads the next event. Returns false if there is none.
  bool next(Event& event);

 private:
  const std::vector<std::uint32_t>& words_;
  std::size_t at_ = 0;
};

}  // namespace discmc::meshing

#endif
