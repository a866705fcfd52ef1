// An extractor that a test starts, feeds and ends itself, and the events that it sends.
#pragma once

#include <doctest/doctest.h>

#include "event_log.hpp"
#include "scan.hpp"

namespace discmc::reference {

/// An extractor in memory of its own, with a log as its sink.
template <class Index>
class Bench {
 public:
  explicit Bench(const Limits& limits, int32_t threshold = 1, uint64_t extra = 1 << 20)
      : block_(Extractor<Index>::minimum_bytes(limits) + extra) {
    require_ok(extractor.start(limits, threshold, block_.memory(), make_sink(log)));
  }
  ~Bench() { CHECK(block_.is_intact()); }
  Bench(const Bench&) = delete;
  Bench& operator=(const Bench&) = delete;

  EventLog log;
  Extractor<Index> extractor;

 private:
  Block block_;
};

}  // namespace discmc::reference
