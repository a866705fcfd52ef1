// The kinds of stream.
#ifndef DISCMC_COMMAND_STREAMS_WIRE_KIND_HPP
#define DISCMC_COMMAND_STREAMS_WIRE_KIND_HPP

namespace discmc::command {

/// What a stream holds.
enum class Wire { regions, slices };

}  // namespace discmc::command

#endif
