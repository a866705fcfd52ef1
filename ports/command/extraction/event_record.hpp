// The events of a scan, kept to be told later.
#ifndef DISCMC_COMMAND_EXTRACTION_EVENT_RECORD_HPP
#define DISCMC_COMMAND_EXTRACTION_EVENT_RECORD_HPP

#include <cstdint>
#include <vector>

#include <discmc/sink.hpp>

namespace discmc::command {

/// Keeps what an extractor tells, but for layer marks: they are true in the order of a single sweep
/// alone. Limit: a scan at once, without skipped rows.
class EventRecord {
 public:
  /// Always takes the event.
  SinkResult take(const Event& event);

  /// Tells all of them. sink: must take everything at once.
  void replay(const Sink& sink) const;

 private:
  std::vector<std::uint32_t> words_;
  StreamHeader header_;
  Statistics totals_{};
  std::uint32_t slices_ = 0;
};

}  // namespace discmc::command

#endif
