// The pipelines: extractors, and behind them encoder, decoder and joiner. The work of each part is
// counted separately.
#pragma once

#include <cstdint>

#include "oracle/volume.hpp"

namespace discmc::doubling {

enum Part : uint8_t { extractor, encoder, decoder, joiner, tests, parts };

/// What a part was given, and what the library did with it.
struct Effort {
  uint64_t work = 0;    ///< voxels, events, links and bytes that went in or came out
  uint64_t blocks = 0;  ///< basic blocks executed
};
struct Efforts {
  Effort of[parts];
};

struct Scanned;

struct Pipeline {
  const char* name;
  void (*run)(const Scanned& scanned);
};

/// All of them.
extern const Pipeline pipelines[];
extern const size_t pipeline_count;

/// Counts what a volume takes.
Efforts run(const Pipeline& pipeline, const reference::BitVolume& volume);

}  // namespace discmc::doubling
