#include <discmc/joiner.hpp>

namespace discmc {

void add_totals(Statistics& sum, const Statistics& other) {
  sum.cells += other.cells;
  sum.facets += other.facets;
  sum.classic_triangles += other.classic_triangles;
  sum.regions += other.regions;
  sum.rings += other.rings;
  sum.links += other.links;
  sum.fragments += other.fragments;
  sum.skipped_rows += other.skipped_rows;
}

Status Joiner::start(Memory memory, const Sink& sink, InputOrder order, Unjoined unjoined) {
  return start(default_capacities(memory.bytes), memory, sink, order, unjoined);
}

Status Joiner::start(const JoinCapacities& capacities, Memory memory, const Sink& sink,
                     InputOrder order, Unjoined unjoined) {
  if (sink.accept == nullptr) return Status::bad_sink;
  if (capacities.fragments < 1 || capacities.fragments > JoinCapacities::max_fragments ||
      capacities.runs < 1 || capacities.runs > JoinCapacities::max_runs)
    return Status::bad_capacities;
  if (memory.data == nullptr || memory.bytes < bytes_for(capacities))
    return Status::too_little_memory;
  *this = Joiner{};
  sink_ = sink;
  order_ = order;
  unjoined_ = unjoined;
  capacities_ = capacities;
  Arena arena(memory);
  waiting_.start(arena, capacities.fragments, capacities.runs);
  return Status::ok;
}

SinkResult Joiner::accept(const Event& event) {
  if (sink_.accept == nullptr) return SinkResult::not_started;
  return deliver_pending() && process(event) ? SinkResult::accepted : answer_;
}

Status Joiner::finish() {
  if (sink_.accept == nullptr) return Status::not_started;
  forget_fragment();
  if (!deliver_pending() || !end()) return status_of(answer_);
  chains().unpoison_free();
  return is_short_ ? Status::too_little_memory : Status::ok;
}

// ---- events, one by one: false if the sink is busy; the event is then sent again ----

bool Joiner::process(const Event& event) {
  const Event::Kind kind = event.kind;
  if (kind == Event::Kind::run) return add_run(event);
  if (kind == Event::Kind::fragment_end) return end_fragment(event);
  if (kind == Event::Kind::lost) return lose(event);
  forget_fragment();  // no fragment is open, unless events break the grammar
  if (kind == Event::Kind::fragment) return begin_fragment(event);
  if (kind == Event::Kind::region_end) return end_region(event);
  if (kind == Event::Kind::finish) return process_finish(event);
  if (kind == Event::Kind::start) return process_start(event);
  return pass(event);
}

bool Joiner::begin_fragment(const Event& event) {
  region_.forget(waiting_);
  if (!is_short_) {
    if (!is_incidence(event.incidence) ||
        !is_direction_of(event.incidence, event.incoming_direction)) {
      fate_ = Fate::ignored;
      return true;
    }
    arriving_ = chains().add(event.incidence, event.start, event.incoming_direction);
    if (arriving_ != detail::join::no_chain) {
      fate_ = Fate::held;
      return true;
    }
    start_passing();
    if (!deliver_pending()) return false;
  }
  if (!pass_loose(event)) return false;
  fate_ = Fate::passed;
  return true;
}

bool Joiner::add_run(const Event& event) {
  if (fate_ == Fate::held) {
    if (!is_run_of(chains()[arriving_].incidence, event.run))
      fate_ = Fate::ignored;
    else if (chains().append(arriving_, event.run, event.normal))
      return true;
    else
      start_passing();
    if (!deliver_pending()) return false;
  }
  if (fate_ == Fate::ignored) return true;
  return fate_ == Fate::passed ? pass_loose(event) : pass(event);
}

bool Joiner::end_fragment(const Event& event) {
  if (fate_ == Fate::held) place_fragment();
  if (!deliver_pending()) return false;
  switch (fate_) {
    case Fate::passed:
      if (!pass_loose(event)) return false;
      ++report_.short_of_memory;
      break;
    case Fate::ignored:
      ++report_.invalid;
      break;
    default:  // the fragment was placed and counted
      return true;
  }
  ++report_.received;
  fate_ = Fate::none;
  return true;
}

bool Joiner::lose(const Event& event) {
  // The sink has received nothing of a held fragment.
  if (fate_ == Fate::none) return pass(event);
  if (fate_ == Fate::passed && !pass_loose(event)) return false;
  forget_fragment();
  return true;
}

// Before the end of a region, its loose holes are delivered.
bool Joiner::end_region(const Event& event) {
  outlet_ = Outlet::holes;
  claimed_ = region_.claim(waiting_);
  begin_next_hole();
  return deliver_pending() && pass(event);
}

// Several streams, such as slabs, share one start: the first.
bool Joiner::process_start(const Event& event) {
  has_start_ = has_start_ || pass(event);
  return has_start_;
}

bool Joiner::process_finish(const Event& event) {
  if (order_ == InputOrder::any || !has_finish_) {
    has_finish_ = true;
    is_abandoned_ = is_abandoned_ || event.is_abandoned;
    slices_ += event.slice;
    if (event.statistics != nullptr) add_totals(totals_, *event.statistics);
  }
  return order_ == InputOrder::any || end();
}

bool Joiner::offer(const Event& event) {
  answer_ = sink_.accept(sink_.context, event);
  return answer_ == SinkResult::accepted;
}

bool Joiner::pass(const Event& event) {
  if (!offer(event)) return false;
  region_.follow(event, waiting_);
  return true;
}

bool Joiner::pass_loose(const Event& event) {
  return !passes_loose() || offer(event);
}

// ---- fragments ----

// Joins the fragment that has arrived with its neighbours.
void Joiner::place_fragment() {
  const uint32_t arrived = arriving_;
  if (chains()[arrived].first_run == detail::join::no_run) {
    fate_ = Fate::ignored;
    return;
  }
  const detail::join::WaitingChains::Result result = waiting_.join(arrived);
  if (result.joined == detail::join::WaitingChains::Joined::no_room) return start_passing();
  ++report_.received;
  fate_ = Fate::none;
  arriving_ = detail::join::no_chain;
  if (result.joined == detail::join::WaitingChains::Joined::refused) return begin_loose(arrived);
  if (result.joined == detail::join::WaitingChains::Joined::open) return;
  chains().close(result.chain);
  const bool is_outer = !chains()[result.chain].is_hole();
  if (is_outer && order_ == InputOrder::sweep)
    begin_delivery(Outlet::region, Event::Kind::region, result.chain);
  else
    waiting_.keep(result.chain);
}

void Joiner::forget_fragment() {
  if (arriving_ != detail::join::no_chain) chains().release(arriving_);
  arriving_ = detail::join::no_chain;
  fate_ = Fate::none;
}

// From now on, all events pass, beginning with the held chains.
void Joiner::start_passing() {
  is_short_ = true;
  if (arriving_ != detail::join::no_chain) fate_ = Fate::passed;
  deliver_all_loose();
}

// ---- delivery ----

// Continues the current delivery, and the delivery of all held chains if they are passed on.
// Returns false if the sink is busy.
bool Joiner::deliver_pending() {
  while (outlet_ != Outlet::none || begin_next_loose()) {
    if (!pass(next_event())) return false;
    select_next();
  }
  return true;
}

Event Joiner::next_event() const {
  Event event{};
  event.kind = next_kind_;
  if (next_kind_ == Event::Kind::region_end || next_kind_ == Event::Kind::fragment_end)
    return event;
  const detail::join::HeldChain& chain = chains()[delivered_];
  if (next_kind_ == Event::Kind::run) {
    const detail::join::HeldRun& first = chains().run(chain.first_run);
    event.run = first.run;
    event.normal = first.normal;
    return event;
  }
  event.incidence = chain.incidence;
  event.incoming_direction = chain.incoming;
  event.is_hole = chain.is_hole();
  event.start = chain.start;
  return event;
}

// Selects the next event after the sink has accepted one.
void Joiner::select_next() {
  switch (next_kind_) {
    case Event::Kind::region:
      next_kind_ = Event::Kind::ring;
      return;
    case Event::Kind::region_end:
      ++report_.regions;
      outlet_ = Outlet::none;
      return;
    case Event::Kind::fragment_end:
      outlet_ = Outlet::none;
      return;
    case Event::Kind::run:
      chains().drop_first_run(delivered_);
      break;
    default:  // ring and fragment
      next_kind_ = Event::Kind::run;
  }
  if (chains()[delivered_].first_run == detail::join::no_run) end_chain();
}

// Ends a chain after its last run.
void Joiner::end_chain() {
  const bool is_outer = !chains()[delivered_].is_hole();
  chains().release(delivered_);
  switch (outlet_) {
    case Outlet::loose:
      next_kind_ = Event::Kind::fragment_end;
      return;
    case Outlet::beginning:
      arriving_ = detail::join::no_chain;
      outlet_ = Outlet::none;
      return;
    default:
      ++report_.rings;
      if (is_outer) claimed_ = region_.claim(waiting_);
      begin_next_hole();
  }
}

void Joiner::begin_delivery(Outlet outlet, Event::Kind kind, uint32_t chain) {
  outlet_ = outlet;
  next_kind_ = kind;
  delivered_ = chain;
}

void Joiner::begin_next_hole() {
  const uint32_t hole = claimed_;
  if (hole != detail::join::no_chain) {
    claimed_ = chains()[hole].next;
    begin_delivery(outlet_, Event::Kind::ring, hole);
  } else if (outlet_ == Outlet::region) {
    next_kind_ = Event::Kind::region_end;
  } else {
    outlet_ = Outlet::none;
  }
}

void Joiner::begin_loose(uint32_t chain) {
  ++(is_short_ ? report_.short_of_memory : report_.unmatched);
  if (passes_loose())
    begin_delivery(Outlet::loose, Event::Kind::fragment, chain);
  else
    chains().release(chain);
}

void Joiner::deliver_all_loose() {
  is_delivering_all_ = true;
  region_.forget(waiting_);
}

// Begins the delivery of the next chain that is passed on. Returns false if none is left.
bool Joiner::begin_next_loose() {
  if (!is_delivering_all_) return false;
  while (last_visited_ < chains().peak()) {
    const uint32_t chain = ++last_visited_;
    if (chain == arriving_ || chains().state(chain) == detail::join::HeldChain::State::unused)
      continue;
    begin_loose(chain);
    if (outlet_ != Outlet::none) return true;
  }
  is_delivering_all_ = false;
  last_visited_ = 0;
  waiting_.forget();
  if (arriving_ == detail::join::no_chain) return false;
  begin_delivery(Outlet::beginning, Event::Kind::fragment, arriving_);
  if (passes_loose()) return true;
  end_chain();
  return false;
}

// ---- the end ----

bool Joiner::end() {
  while (begin_next_outer())
    if (!deliver_pending()) return false;
  deliver_all_loose();
  return deliver_pending() && send_finish();
}

// Begins the delivery of a waiting outer ring. Returns false if none is left.
bool Joiner::begin_next_outer() {
  const uint32_t outer = waiting_.rings().remove_outer(chains());
  if (outer == detail::join::no_chain) return false;
  begin_delivery(Outlet::region, Event::Kind::region, outer);
  return true;
}

bool Joiner::send_finish() {
  if (!has_finish_) return true;
  Statistics totals = totals_;
  totals.regions += report_.regions;
  totals.rings += report_.rings;
  totals.fragments = passes_loose() ? report_.unmatched + report_.short_of_memory : 0;
  Event event{};
  event.kind = Event::Kind::finish;
  event.slice = slices_;
  event.is_abandoned = is_abandoned_;
  event.statistics = &totals;
  has_finish_ = !offer(event);
  return !has_finish_;
}

}  // namespace discmc
