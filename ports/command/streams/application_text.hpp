// The content of application records as text.
#pragma once

#include <string>

#include <discmc/sink.hpp>

namespace discmc::command {

/// Describes a record in one line: its kind, its position in the stream, and its bytes or
/// placement.
std::string text(const ApplicationRecord& record);

}  // namespace discmc::command
