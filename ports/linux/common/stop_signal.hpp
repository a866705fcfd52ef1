// Requests to end: Ctrl-C or SIGTERM. A scan then ends in order, and its stream is valid.
#pragma once

namespace discmc::device::stop_signal {

/// From now on signals are recorded, and waiting system calls end with EINTR.
void watch();

bool came();

}  // namespace discmc::device::stop_signal
