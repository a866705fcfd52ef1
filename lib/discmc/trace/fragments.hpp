// Fragments grow at the vertices that chains pass, join, and close to rings.
#ifndef DISCMC_TRACE_FRAGMENTS_HPP
#define DISCMC_TRACE_FRAGMENTS_HPP

#include <discmc/trace/passes.hpp>
#include <discmc/trace/queues.hpp>
#include <discmc/trace/run_list.hpp>

namespace discmc::trace {

/// The coordinate that tells a link's place on its line, and how far a link goes along it.
struct LinkStep {
  uint8_t axis;
  bool is_back;
  uint8_t shift;  ///< a link takes 1 << shift half-steps
};
struct LinkSteps {
  LinkStep of[link_codes];
};
namespace derive {
constexpr LinkSteps link_steps() {
  LinkSteps steps{};
  for (Link link = 0; link < link_codes; ++link) {
    const Vertex v = link_vector(link);
    const int axis = v.x != 0 ? 0 : v.y != 0 ? 1 : 2;
    const int part = axis == 0 ? v.x : axis == 1 ? v.y : v.z;
    steps.of[link] = {static_cast<uint8_t>(axis), part < 0,
                      static_cast<uint8_t>(part == 2 || part == -2 ? 1 : 0)};
  }
  return steps;
}
}  // namespace derive
inline constexpr LinkSteps link_steps = derive::link_steps();

/// How many links lead from one coordinate to another, which lies ahead by less than Side::modulus.
inline uint32_t links_between(int32_t from, int32_t to, Link link) {
  const LinkStep step = link_steps.of[link];
  const int32_t way = step.is_back ? from - to : to - from;
  return (static_cast<uint32_t>(way) & (Side::modulus - 1)) >> step.shift;
}

inline int32_t coordinate(const Vertex& v, int axis) {
  return axis == 0 ? v.x : axis == 1 ? v.y : v.z;
}

/// v moved along a link. Coordinates wrap.
inline Vertex moved(const Vertex& v, Link link, uint32_t times) {
  const Vertex step = link_vector(link);
  const auto add = [times](int32_t from, int32_t by) {
    return static_cast<int32_t>(static_cast<uint32_t>(from) + static_cast<uint32_t>(by) * times);
  };
  return {add(v.x, step.x), add(v.y, step.y), add(v.z, step.z)};
}
inline Vertex moved_back(const Vertex& v, Link link, uint32_t times) {
  return moved(v, link, 0 - times);
}

inline uint32_t tune_plenty = 0, tune_divisor = 8, tune_kept = 0, tune_most = ~0u;
/// A chain that leaves the pool: a closed ring, or a loose fragment.
template <class Index>
struct Outgoing {
  enum class Kind : uint8_t { none, ring, fragment };
  Kind kind = Kind::none;
  Incidence incidence = 0;
  Direction came = 0;  // of a fragment
  Index last = no_record;
  Vertex start{0, 0, 0};
};

/// Index and Normal as of the records.
template <class Index, class Normal>
class Fragments {
 public:
  using Records = Pool<Record<Index, Normal>, Index>;
  using Lists = RunLists<Index, Normal>;
  using Slot = typename Lists::Slot;

  /// The least capacity with which a scan works.
  static constexpr uint32_t least_capacity = 2;

  /// sends: a shortage of records sends loose fragments; without it there must be none.
  void start(Record<Index, Normal>* records, uint32_t capacity, Queue<Index>* queues, bool sends) {
    records_.start(records, capacity);
    queues_.start(queues);
    sends_ = sends;
    kept_for_slice_ = capacity / 64 < 64 ? capacity / 64 : 64;
    plenty_ = tune_plenty ? tune_plenty : capacity; divisor_ = tune_divisor;
  }
  void clear() {
    records_.clear();
    queues_.clear();
    outgoing_.kind = Outgoing<Index>::Kind::none;
  }

  /// Takes a chain's pass at a vertex in. Limit: !has_outgoing().
  /// normals.normal_at(vertex) tells the normal at a corner. Cost: constant, but for what is sent.
  template <class Normals>
  void take(const Pass& pass, const Vertex& vertex, const Normals& normals);

  bool has_outgoing() const { return outgoing_.kind != Outgoing<Index>::Kind::none; }
  Outgoing<Index> take_outgoing() {
    const Outgoing<Index> out = outgoing_;
    outgoing_.kind = Outgoing<Index>::Kind::none;
    return out;
  }
  Records& records() { return records_; }
  const Records& records() const { return records_; }
  /// Records that may be taken without more ado.
  uint32_t spare() const { return queues_.spare(records_); }

 private:
  using EndRecord = End<Index, Normal>;

  // The new runs of a pass, and the side under way behind them.
  struct Sides {
    bool is_open = false;
    Incidence incidence = 0;
    Link along = 0;
    Vertex from{0, 0, 0};
    Normal normal{};
    Vertex start{0, 0, 0};  // of the first run
    uint32_t count = 0;
    Slot run[3];

    void open(Link link, const Vertex& at, Normal normal_there) {
      is_open = true;
      along = link;
      from = at;
      normal = normal_there;
    }
    void complete(const Vertex& to);
  };

  EndRecord& end(Index index) { return records_[index].end; }
  static uint32_t links_from(Side side, const Vertex& to, Link link) {
    return links_between(side.coordinate(), coordinate(to, link_steps.of[link].axis), link);
  }
  static uint32_t links_to(Side side, const Vertex& from, Link link) {
    return links_between(coordinate(from, link_steps.of[link].axis), side.coordinate(), link);
  }
  static Side side_at(const Vertex& corner, Link link, Direction direction) {
    return Side(direction, coordinate(corner, link_steps.of[link].axis));
  }

  bool admits(uint8_t queue) const;
  Index admit(uint8_t queue, Index old);
  bool goes_on_straight(const Pass& pass, const Vertex& vertex, Index coming, Index going);
  void store(const Sides& sides, Index begin, Index tail, Index before, Index after);
  void wire(Index begin, Index tail, Index last);

  Vertex begin_of(Incidence incidence, Index last, const Vertex& end) const;
  bool should_send(Index before, Index after) const;

  bool sends_ = true;
  uint32_t kept_for_slice_ = 0;  // from ends that wait for the next slice
  uint32_t plenty_ = 0;          // with as many records left nothing is sent
  uint32_t divisor_ = 8;
  Outgoing<Index> outgoing_;
  Records records_;
  Queues<Index, Normal> queues_;
};

// ---- implementation ----

template <class Index, class Normal>
void Fragments<Index, Normal>::Sides::complete(const Vertex& to) {
  const int axis = link_steps.of[along].axis;
  const uint32_t length = links_between(coordinate(from, axis), coordinate(to, axis), along);
  if (count == 0) start = from;
  run[count].run = short_run(sector_table.direction[incidence][along], length);
  run[count].set_normal(normal);
  ++count;
}

// Ends of links that stay within the slice are the last to be lost: they free their records soon.
template <class Index, class Normal>
bool Fragments<Index, Normal>::admits(uint8_t queue) const {
  const uint32_t kept = queue >= first_rising_queue ? kept_for_slice_ : 0;
  return spare() >= 4 + kept || !sends_;
}

// Makes an end wait, in the record of an old one if there is any. no_record when it is lost.
template <class Index, class Normal>
Index Fragments<Index, Normal>::admit(uint8_t queue, Index old) {
  if (admits(queue)) {
    const Index index = old != no_record ? old : records_.take();
    queues_.push(records_, queue, index);
    return index;
  }
  if (old != no_record) records_.give(old);
  queues_.push_lost(records_, queue);
  return no_record;
}

// A chain without a corner here only moves its end.
template <class Index, class Normal>
bool Fragments<Index, Normal>::goes_on_straight(const Pass& pass, const Vertex& vertex,
                                                Index coming, Index going) {
  const bool is_tail = coming != no_record && pass.goes_ahead;
  const bool is_begin = going != no_record && pass.comes_from_ahead;
  if (!is_tail && !is_begin) return false;
  const uint8_t queue = is_tail ? pass.out : pass.in;
  const Index index = is_tail ? coming : going;
  const uint32_t links = is_tail ? links_from(end(index).side, vertex, pass.came)
                                 : links_to(end(index).side, vertex, pass.first);
  if (links >= Side::longest || !admits(queue)) return false;
  queues_.push(records_, queue, index);
  return true;
}

template <class Index, class Normal>
template <class Normals>
void Fragments<Index, Normal>::take(const Pass& pass, const Vertex& vertex,
                                    const Normals& normals) {
  const Index coming = pass.comes_from_ahead ? Index{no_record} : queues_.pop(records_, pass.in);
  const Index going = pass.goes_ahead ? Index{no_record} : queues_.pop(records_, pass.out);
  if (pass.came == pass.first && pass.first == pass.second &&
      goes_on_straight(pass, vertex, coming, going))
    return;

  const EndRecord came = coming != no_record ? end(coming) : EndRecord{};
  const EndRecord went = going != no_record ? end(going) : EndRecord{};
  Index tail = no_record, begin = no_record;
  if (pass.goes_ahead)
    tail = admit(pass.out, coming);
  else if (coming != no_record)
    records_.give(coming);
  if (pass.comes_from_ahead)
    begin = admit(pass.in, going);
  else if (going != no_record)
    records_.give(going);

  // The side under way from the last corner before the vertex to the first one after it. Where it
  // began is not known of a chain that comes from ahead: its begin is where that side ends.
  Sides sides;
  sides.incidence = pass.incidence;
  const Direction arriving = sector_table.direction[pass.incidence][pass.came];
  const auto end_side = [&](const Vertex& corner) {
    if (sides.is_open)
      sides.complete(corner);
    else if (begin != no_record)
      end(begin).side = side_at(corner, pass.came, arriving);
  };
  bool is_corner = pass.came != pass.first;
  if (coming != no_record) {
    const uint32_t links = links_from(came.side, vertex, pass.came);
    sides.open(pass.came, moved_back(vertex, pass.came, links), came.normal());
    is_corner = is_corner || links >= Side::longest;
  } else {
    is_corner = is_corner || begin == no_record || tail != no_record ||
                (going != no_record && links_to(went.side, vertex, pass.first) >= Side::longest);
  }
  if (is_corner) {
    end_side(vertex);
    sides.open(pass.first, vertex, normals.normal_at(vertex));
  }
  Vertex next = moved(vertex, pass.first, 1);
  if (pass.second != pass.first) {
    end_side(next);
    sides.open(pass.second, next, normals.normal_at(next));
  }
  if (pass.has_centroid) next = moved(next, pass.second, 1);
  if (tail != no_record) {
    end(tail).side =
        side_at(sides.from, sides.along, sector_table.direction[pass.incidence][sides.along]);
    end(tail).set_normal(sides.normal);
  } else {
    if (going != no_record) next = moved(next, pass.second, links_to(went.side, next, pass.second));
    end_side(next);
  }

  Index before = coming != no_record ? came.last : Index{no_record};
  if (coming != no_record && came.mate == going) {
    for (uint32_t i = 0; i < sides.count; ++i) Lists::append(records_, before, sides.run[i]);
    outgoing_ = {Outgoing<Index>::Kind::ring, pass.incidence, 0, before, next};
    return;
  }
  const bool went_is_loose = is_loose<Index>(went.mate);
  const Index after = going == no_record ? Index{no_record}
                      : went_is_loose    ? went.last
                                         : end(went.mate).last;
  if (begin == no_record)
    begin = coming != no_record ? came.mate : loose_end<Index>(arriving);
  if (tail == no_record) tail = going != no_record ? went.mate : loose_end<Index>();
  store(sides, begin, tail, before, after);
}

// The runs of a fragment that has changed: those before the new ones, the new ones, those after.
template <class Index, class Normal>
void Fragments<Index, Normal>::store(const Sides& sides, Index begin, Index tail, Index before,
                                     Index after) {
  const bool is_whole = is_loose(begin) && is_loose(tail);
  const bool is_sent = is_whole || (sides.count > 0 && should_send(before, after));
  const Vertex start = is_sent ? begin_of(sides.incidence, before, sides.start) : Vertex{0, 0, 0};
  if (before == no_record && after != no_record) {
    for (uint32_t i = sides.count; i-- > 0;) Lists::prepend(records_, after, sides.run[i]);
  } else {
    for (uint32_t i = 0; i < sides.count; ++i) Lists::append(records_, before, sides.run[i]);
  }
  const Index last = Lists::concatenate(records_, before, after);
  if (!is_sent) return wire(begin, tail, last);
  const Direction came = is_loose(begin) ? begin & 7 : end(begin).side.direction();
  outgoing_ = {Outgoing<Index>::Kind::fragment, sides.incidence, came, last, start};
  const RunRecord<Index, Normal>& runs = records_[last].runs;
  const ShortRun last_run =
      runs.slot[2].run != 0 ? runs.slot[2].run : runs.slot[1].run != 0 ? runs.slot[1].run : runs.slot[0].run;
  if (!is_loose(begin)) wire(begin, loose_end<Index>(), no_record);
  if (!is_loose(tail)) wire(loose_end<Index>(last_run & 7), tail, no_record);
}

// Makes the two ends of a fragment name each other, and one of them its runs.
template <class Index, class Normal>
void Fragments<Index, Normal>::wire(Index begin, Index tail, Index last) {
  if (!is_loose(begin)) {
    end(begin).mate = tail;
    end(begin).last = is_loose(tail) ? last : Index{no_record};
  }
  if (!is_loose(tail)) {
    end(tail).mate = begin;
    end(tail).last = last;
  }
}

// Where a list of runs begins that ends at a vertex.
template <class Index, class Normal>
Vertex Fragments<Index, Normal>::begin_of(Incidence incidence, Index last,
                                          const Vertex& end) const {
  if (last == no_record) return end;
  Vertex at = end;
  const RunCursor<Index, Normal> first(records_, last);
  RunCursor<Index, Normal> cursor = first;
  do {
    const Run run = long_run(cursor.run(records_));
    at = moved_back(at, link_of(incidence, run.direction()), run.length());
    cursor.advance(records_);
  } while (cursor != first);
  return at;
}

// The fewer records are left, the shorter a fragment may be to be sent as it stands; with none left
// any is, and gives back what the pass has taken.
template <class Index, class Normal>
bool Fragments<Index, Normal>::should_send(Index before, Index after) const {
  const uint32_t left = spare();
  if (!sends_ || left >= plenty_) return false;
  if (left < 4) return true;
  return Lists::are_longer(records_, before, after, left / divisor_ < tune_most ? left / divisor_ : tune_most);
}

}  // namespace discmc::trace

#endif
