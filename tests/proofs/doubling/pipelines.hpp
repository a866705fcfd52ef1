// The pipelines: extractors, followed by encoder, decoder and joiner. The work of each part is
// counted separately.
#pragma once

#include <cstdint>

#include "oracle/volume.hpp"

namespace discmc::doubling {

enum Part : uint8_t { extractor, encoder, decoder, joiner, tests, parts };

/// The input and output of a part, and the cost of processing them.
struct Effort {
  uint64_t work = 0;    ///< voxels, events, links and bytes, in and out
  uint64_t blocks = 0;  ///< executed basic blocks
};
struct Efforts {
  Effort by_part[parts];
};

struct Scanned;

struct Pipeline {
  const char* name;
  void (*run)(const Scanned& scanned);
};

/// Returns all pipelines.
extern const Pipeline pipelines[];
extern const size_t pipeline_count;

/// Returns the work and the blocks of each part for a volume.
Efforts run(const Pipeline& pipeline, const reference::BitVolume& volume);

}  // namespace discmc::doubling
