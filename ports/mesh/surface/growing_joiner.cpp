#include "growing_joiner.hpp"

#include <stdexcept>

namespace discmc::meshing {
namespace {

bool is_of_region(Event::Kind kind) {
  return kind == Event::Kind::region || kind == Event::Kind::ring || kind == Event::Kind::run ||
         kind == Event::Kind::region_end;
}

}  // namespace

GrowingJoiner::GrowingJoiner(const Sink& sink, InputOrder order, std::size_t bytes,
                             std::optional<Limit> limit)
    : sink_(sink), order_(order), bytes_(bytes), limit_(limit), memory_(new std::uint8_t[bytes]) {
  const Sink joined{this, [](void* context, const Event& event) {
                      return static_cast<GrowingJoiner*>(context)->pass(event);
                    }};
  const Status started = joiner_.start({memory_.get(), bytes_}, joined, order_);
  if (started != Status::ok) throw std::invalid_argument(to_string(started));
}

SinkResult GrowingJoiner::accept(const Event& event) {
  has_fragments_ = has_fragments_ || event.kind == Event::Kind::fragment;
  return has_fragments_ || !is_of_region(event.kind) ? joiner_.accept(event)
                                                     : sink_.accept(sink_.context, event);
}

void GrowingJoiner::finish() {
  // A joiner that ran short of memory has a successor, perhaps only since its finish.
  for (GrowingJoiner* joiner = this; joiner != nullptr; joiner = joiner->next_.get())
    static_cast<void>(joiner->joiner_.finish());
}

const Statistics& GrowingJoiner::totals() const {
  const GrowingJoiner* last = this;
  while (last->next_) last = last->next_.get();
  return last->totals_;
}

SinkResult GrowingJoiner::pass(const Event& event) {
  const bool has_room = next_ == nullptr && !is_beyond_limit_;
  if (event.kind == Event::Kind::fragment && has_room && !update_unmatched()) grow();
  if (event.kind == Event::Kind::finish) totals_ = *event.statistics;
  if (next_) return next_->accept(event);
  const Sink& sink = is_beyond_limit_ ? limit_->beyond : sink_;
  return sink.accept(sink.context, event);
}

void GrowingJoiner::grow() {
  // All joiners before this one together have a third of its memory.
  is_beyond_limit_ = limit_ && bytes_ + bytes_ / 3 + 4 * std::uint64_t{bytes_} > limit_->bytes;
  if (!is_beyond_limit_) next_ = std::make_unique<GrowingJoiner>(sink_, order_, 4 * bytes_, limit_);
}

// Returns whether the leaving fragment has no partner. Otherwise the joiner ran short of memory.
bool GrowingJoiner::update_unmatched() {
  const std::uint64_t before = unmatched_;
  unmatched_ = joiner_.report().unmatched;
  return unmatched_ > before;
}

}  // namespace discmc::meshing
