// What the command says of a surface: the table after `extract`, the lines of `info`.
#ifndef DISCMC_COMMAND_SUMMARY_HPP
#define DISCMC_COMMAND_SUMMARY_HPP

#include <array>
#include <optional>
#include <ostream>
#include <vector>

#include <discmc/decoder.hpp>

#include "extraction/extraction.hpp"
#include "surface/counts.hpp"
#include "volumes/volume_placement.hpp"

namespace discmc::host {

/// A short table for people: what came in, what came out, what it took. slice_encoder_bytes: of the
/// device's memory for a stream of slices; 0 for regions, which take an arena.
void write_table(const Extraction& extraction, const Counts& counts, std::uint64_t stream_bytes,
                 std::uint64_t slice_encoder_bytes, std::ostream& out);

/// Spacing and placement as lines of `info`, for streams and volumes.
void write_place(const std::array<double, 3>& spacing_mm,
                 const std::optional<VolumePlacement>& placement, std::ostream& out);

/// One `key value` a line, for people and programs. channel: of the surface that was counted.
/// streams: all that share the link with it. placement: where the stream tells one.
void write_info(const StreamHeader& header, std::uint8_t channel,
                const std::vector<StreamHeader>& streams, const StreamReport& report,
                const Counts& counts, const std::optional<VolumePlacement>& placement,
                std::ostream& out);

}  // namespace discmc::host

#endif
