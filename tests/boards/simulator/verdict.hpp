// Compares the received stream with the one expected from the sent rows.
#pragma once

#include <string>
#include <vector>

#include "options.hpp"
#include "received.hpp"

namespace discmc::simulator {

/// Describes all faults; empty if there are none.
///
/// The last stream must be complete, and equal byte by byte to an extraction in this process that
/// skips the same rows. All rows that the scanner did not send completely must be skipped, and no
/// others if it waited for the device. A stream cut by a reset must be the beginning of such a
/// stream.
std::vector<std::string> mistakes(const Rows& rows, const Options& options,
                                  const Received& received);

/// Returns the rows that were sent completely but skipped, because the device had no room for them.
std::size_t overruns(const ScannerBehaviour& scanner, const ReceivedStream& stream);

}  // namespace discmc::simulator
