// Records the events of a scan, to send them later.
#ifndef DISCMC_MESH_EXTRACTION_EVENT_RECORD_HPP
#define DISCMC_MESH_EXTRACTION_EVENT_RECORD_HPP

#include <cstdint>
#include <vector>

#include <discmc/sink.hpp>

namespace discmc::meshing {

/// Keeps the events of an extractor except layer marks, which are valid only in the order of one
/// sweep. Limit: one scan at a time, without skipped rows.
class EventRecord {
 public:
  /// Always accepts the event.
  SinkResult accept(const Event& event);

  /// Sends all events. sink: must accept everything at once.
  void replay(const Sink& sink) const;

 private:
  std::vector<std::uint32_t> words_;
  StreamHeader header_;
  Statistics totals_{};
  std::uint32_t slices_ = 0;
};

}  // namespace discmc::meshing

#endif
