#include "event_record.hpp"

#include "surface/event_words.hpp"

namespace discmc::meshing {

SinkResult EventRecord::accept(const Event& event) {
  if (event.kind == Event::Kind::layer) return SinkResult::accepted;
  if (event.kind == Event::Kind::start) header_ = *event.header;
  if (event.kind == Event::Kind::finish) {
    totals_ = *event.statistics;
    slices_ = event.slice;
  }
  append_words(event, words_);
  return SinkResult::accepted;
}

void EventRecord::replay(const Sink& sink) const {
  Event event;
  for (EventWords words(words_); words.next(event);) {
    if (event.kind == Event::Kind::start) event.header = &header_;
    if (event.kind == Event::Kind::finish) {
      event.statistics = &totals_;
      event.slice = slices_;
    }
    static_cast<void>(sink.accept(sink.context, event));
  }
}

}  // namespace discmc::meshing
