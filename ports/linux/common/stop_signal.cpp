#include "stop_signal.hpp"

#include <signal.h>

#include <initializer_list>

namespace discmc::device::stop_signal {
namespace {

volatile sig_atomic_t noted = 0;

}  // namespace

void watch() {
  struct sigaction action {};
  action.sa_handler = [](int) { noted = 1; };
  for (const int signal : {SIGINT, SIGTERM, SIGHUP}) sigaction(signal, &action, nullptr);
}

bool came() {
  return noted != 0;
}

}  // namespace discmc::device::stop_signal
