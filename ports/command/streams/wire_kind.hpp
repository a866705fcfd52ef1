// The kinds of stream.
#pragma once

namespace discmc::command {

/// What a stream holds.
enum class Wire { regions, slices };

}  // namespace discmc::command
