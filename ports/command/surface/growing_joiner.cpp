#include "growing_joiner.hpp"

#include <stdexcept>

namespace discmc::host {
namespace {

bool is_of_region(Event::Kind kind) {
  return kind == Event::Kind::region || kind == Event::Kind::ring || kind == Event::Kind::run ||
         kind == Event::Kind::region_end;
}

}  // namespace

GrowingJoiner::GrowingJoiner(const Sink& sink, InputOrder order, std::size_t bytes)
    : sink_(sink), order_(order), bytes_(bytes), memory_(new std::uint8_t[bytes]) {
  const Sink joined{this, [](void* context, const Event& event) {
                      return static_cast<GrowingJoiner*>(context)->pass(event);
                    }};
  const Status started = joiner_.start({memory_.get(), bytes_}, joined, order_);
  if (started != Status::ok) throw std::invalid_argument(text(started));
}

Answer GrowingJoiner::take(const Event& event) {
  has_fragments_ = has_fragments_ || event.kind == Event::Kind::fragment;
  return has_fragments_ || !is_of_region(event.kind) ? joiner_.take(event)
                                                     : sink_.take(sink_.context, event);
}

void GrowingJoiner::finish() {
  // One that was short of memory has another behind it, perhaps only since it finished.
  for (GrowingJoiner* joiner = this; joiner != nullptr; joiner = joiner->next_.get())
    static_cast<void>(joiner->joiner_.finish());
}

Answer GrowingJoiner::pass(const Event& event) {
  if (event.kind == Event::Kind::fragment && !next_ && !is_unmatched())
    next_ = std::make_unique<GrowingJoiner>(sink_, order_, 4 * bytes_);
  return next_ ? next_->take(event) : sink_.take(sink_.context, event);
}

// Whether the fragment that comes out has no partner. Else the joiner is short of memory.
bool GrowingJoiner::is_unmatched() {
  const std::uint64_t before = unmatched_;
  unmatched_ = joiner_.report().unmatched;
  return unmatched_ > before;
}

}  // namespace discmc::host
