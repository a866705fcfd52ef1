#include "spilling_joiner.hpp"

#include <utility>

#include <discmc/chain.hpp>

#include "surface/event_words.hpp"

namespace discmc::command {

SinkResult PlaneSpill::accept(const Event& event) {
  switch (event.kind) {
    case Event::Kind::region:
      region_ = event;
      group_ = nullptr;
      break;
    case Event::Kind::ring:
      begin_ring(event);
      break;
    case Event::Kind::fragment:
      is_fragment_ = true;
      group_ = &group_of(event.incidence, event.start);
      ++group_->fragments;
      append(event);
      break;
    case Event::Kind::run:
      if (group_ != nullptr && is_fragment_) ++group_->runs;
      append(event);
      break;
    case Event::Kind::region_end:
    case Event::Kind::fragment_end:
    case Event::Kind::lost:
      append(event);
      group_ = nullptr;
      break;
    case Event::Kind::finish:
      finish_ = event;
      totals_ = *event.statistics;
      finish_.statistics = &totals_;
      has_finish_ = true;
      break;
    case Event::Kind::layer:  // valid only in the order of a sweep
      break;
    default:
      return sink_.accept(sink_.context, event);
  }
  return SinkResult::accepted;
}

PlaneSpill::Group& PlaneSpill::group_of(Incidence incidence, const Vertex& vertex) {
  const auto offset = static_cast<std::uint32_t>(plane_offset(incidence, vertex));
  constexpr std::uint32_t spread = 0x9E3779B1;  // neighbours go to groups far apart
  return groups_[(offset * 32 + incidence) * spread >> 24];
}

void PlaneSpill::begin_ring(const Event& event) {
  if (region_) {
    is_fragment_ = false;
    group_ = &group_of(region_->incidence, event.start);
    append(*std::exchange(region_, std::nullopt));
  }
  append(event);
}

void PlaneSpill::append(const Event& event) {
  if (group_ == nullptr) return;  // the region has no ring
  append_words(event, group_->words);
  constexpr std::size_t block_words = 16384;
  if (group_->words.size() >= block_words) write(*group_);
}

void PlaneSpill::write(Group& group) {
  if (!file_) file_.emplace();
  const std::uint64_t begin =
      file_->append(group.words.data(), group.words.size() * sizeof group.words[0]);
  group.blocks.push_back({begin, group.words.size()});
  group.words.clear();
}

void PlaneSpill::join() {
  for (Group& group : groups_) join(group);
  if (has_finish_) sink_.accept(sink_.context, finish_);
}

void PlaneSpill::join(Group& group) {
  const std::uint64_t run_bytes = 24;  // by the default split of a Joiner's memory
  const std::uint64_t bytes = run_bytes * std::max(8 * group.fragments, group.runs);
  const Sink joined{this, [](void* context, const Event& event) {
                      return static_cast<PlaneSpill*>(context)->pass(event);
                    }};
  GrowingJoiner joiner(joined, InputOrder::any, std::max<std::uint64_t>(bytes, 4096));
  replay(group, joiner);
  if (has_finish_) joiner.accept(finish_);
  joiner.finish();
  if (has_finish_) totals_ = joiner.totals();  // for the next group, which adds its totals
  group = {};
}

void PlaneSpill::replay(const Group& group, GrowingJoiner& joiner) {
  std::vector<std::uint32_t> words;
  Event event;
  for (const Block& block : group.blocks) {
    words.resize(block.words);
    file_->read(block.begin, words.data(), block.words * sizeof words[0]);
    for (EventWords reader(words); reader.next(event);) joiner.accept(event);
  }
  for (EventWords reader(group.words); reader.next(event);) joiner.accept(event);
}

// Passes the events of a group to the sink, except `finish`: other groups follow.
SinkResult PlaneSpill::pass(const Event& event) {
  const bool is_end = event.kind == Event::Kind::finish;
  return is_end ? SinkResult::accepted : sink_.accept(sink_.context, event);
}

}  // namespace discmc::command
