// The wish to end: Ctrl-C, or a SIGTERM. A scan then ends in order, and its stream is valid.
#pragma once

namespace discmc::device::stop_signal {

/// From here on the signals are noted, and system calls that wait end with EINTR.
void watch();

bool came();

}  // namespace discmc::device::stop_signal
