// Whether what came is what the rows that were sent should have made.
#pragma once

#include <string>
#include <vector>

#include "options.hpp"
#include "received.hpp"

namespace discmc::simulator {

/// What is wrong, in sentences; empty when nothing is.
///
/// The last stream must be complete and equal, byte by byte, to an extraction in this process that
/// skips the same rows. All rows that the scanner did not send whole must be skipped, and no others
/// if it waited for the device. A stream cut off by a reset must be the beginning of such a stream.
std::vector<std::string> mistakes(const Rows& rows, const Options& options,
                                  const Received& received);

/// Rows that were sent whole but are skipped: the device had no room for them.
std::size_t overruns(const ScannerBehaviour& scanner, const ReceivedStream& stream);

}  // namespace discmc::simulator
