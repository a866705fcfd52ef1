// The content of application records, in words.
#pragma once

#include <string>

#include <discmc/sink.hpp>

namespace discmc::command {

/// A record in one line: its kind, its place in the stream, and its bytes or its placement.
std::string text(const ApplicationRecord& record);

}  // namespace discmc::command
