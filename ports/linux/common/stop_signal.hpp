// The wish to end: Ctrl-C, or a SIGTERM. A scan then ends in order, and its stream is valid.
#ifndef DISCMC_LINUX_COMMON_STOP_SIGNAL_HPP
#define DISCMC_LINUX_COMMON_STOP_SIGNAL_HPP

namespace discmc::device::stop_signal {

/// From here on the signals are noted, and system calls that wait end with EINTR.
void watch();

bool came();

}  // namespace discmc::device::stop_signal

#endif
