// Interrupts work after any instruction, on x86-64 under Linux: single-steps the processor, with a
// signal handler as the interrupt.
#pragma once

#include <cstdint>

#if defined(__x86_64__) && defined(__linux__) && defined(__GNUC__)
#include <signal.h>
#include <ucontext.h>
#endif

namespace discmc::reference {

#if defined(__x86_64__) && defined(__linux__) && defined(__GNUC__)

/// Whether interrupts are possible: not under the thread sanitizer, which delays signals. Under
/// valgrind none arrives.
#if defined(__SANITIZE_THREAD__)
constexpr bool can_single_step = false;
#else
constexpr bool can_single_step = true;
#endif

namespace stepping {

constexpr uint32_t trap_flag = 0x100;

struct Interrupt {
  uint64_t left = 0;  // instructions until the interrupt
  void (*handle)(void* context) = nullptr;
  void* context = nullptr;
};
inline Interrupt interrupt;

// The processor does not step through the handler, nor beyond the interrupt.
inline void on_step(int, siginfo_t*, void* context) {
  if (interrupt.left == 0 || --interrupt.left > 0) return;
  interrupt.handle(interrupt.context);
  static_cast<ucontext_t*>(context)->uc_mcontext.gregs[REG_EFL] &= ~greg_t{trap_flag};
}

}  // namespace stepping

/// Runs `work`, and interrupts it once, after instruction number `at`. Returns false if the work
/// has fewer instructions; then there was no interrupt.
template <class Work, class Interrupt>
bool interrupted(uint64_t at, Work work, Interrupt interrupt) {
  struct sigaction action {
  }, before{};
  action.sa_sigaction = stepping::on_step;
  action.sa_flags = SA_SIGINFO;
  sigaction(SIGTRAP, &action, &before);
  stepping::interrupt = {at, [](void* context) { (*static_cast<Interrupt*>(context))(); },
                         &interrupt};
  const auto flags = __builtin_ia32_readeflags_u64();
  __builtin_ia32_writeeflags_u64(flags | stepping::trap_flag);
  work();
  __builtin_ia32_writeeflags_u64(flags);
  const bool came = stepping::interrupt.left == 0;
  stepping::interrupt.left = 0;
  sigaction(SIGTRAP, &before, nullptr);
  return came;
}

#else

constexpr bool can_single_step = false;

template <class Work, class Interrupt>
bool interrupted(uint64_t, Work, Interrupt) {
  return false;
}

#endif

}  // namespace discmc::reference
