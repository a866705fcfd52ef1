#include "event_words.hpp"

namespace discmc::meshing {
namespace {

// Marks words other than a run without a normal, whose length is always smaller.
constexpr std::uint32_t event_mark = std::uint32_t{1} << 31;
static_assert(Run::max_length < event_mark >> 3);

bool has_vertex(Event::Kind kind) {
  return kind == Event::Kind::ring || kind == Event::Kind::fragment;
}

std::uint32_t word_of(const Event& event) {
  std::uint32_t high = event.incidence, low = event.incoming_direction;
  if (event.kind == Event::Kind::ring) low = event.is_hole;
  if (event.kind == Event::Kind::run) {
    high = event.normal.u;
    low = event.normal.v;
  }
  return event_mark | static_cast<std::uint32_t>(event.kind) << 16 | high << 8 | low;
}

Event event_of(std::uint32_t word) {
  const auto high = static_cast<std::uint8_t>(word >> 8 & 0xFF);
  const auto low = static_cast<std::uint8_t>(word & 0xFF);
  Event event{};
  event.kind = static_cast<Event::Kind>(word >> 16 & 0xFF);
  if (event.kind == Event::Kind::run) {
    event.normal = {high, low};
    return event;
  }
  event.incidence = high;
  event.incoming_direction = low;
  event.is_hole = low != 0;
  return event;
}

}  // namespace

void append_words(const Event& event, std::vector<std::uint32_t>& words) {
  const bool is_run = event.kind == Event::Kind::run;
  if (!is_run || !event.normal.is_none()) words.push_back(word_of(event));
  if (is_run) words.push_back(event.run.code());
  if (!has_vertex(event.kind)) return;
  for (const std::int32_t coordinate : {event.start.x, event.start.y, event.start.z})
    words.push_back(static_cast<std::uint32_t>(coordinate));
}

bool EventWords::next(Event& event) {
  if (at_ == words_.size()) return false;
  const auto following = [this] { return words_[at_++]; };
  const std::uint32_t first = following();
  const bool is_code = first < event_mark;
  event = is_code ? Event{} : event_of(first);
  if (is_code) event.kind = Event::Kind::run;
  if (event.kind == Event::Kind::run) event.run = Run::from_code(is_code ? first : following());
  if (!has_vertex(event.kind)) return true;
  for (std::int32_t* const coordinate : {&event.start.x, &event.start.y, &event.start.z})
    *coordinate = static_cast<std::int32_t>(following());
  return true;
}

}  // namespace discmc::meshing
