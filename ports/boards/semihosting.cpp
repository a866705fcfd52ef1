#include "semihosting.hpp"

#include "port.hpp"

namespace {

// Operations and arguments of Arm's "Semihosting for AArch32 and AArch64", which RISC-V uses, too.
// Every argument has the width of a pointer.
constexpr uintptr_t sys_open = 0x01, sys_write0 = 0x04, sys_read = 0x06, sys_exit_extended = 0x20;
constexpr uintptr_t mode_read_binary = 1;
constexpr uintptr_t application_exit = 0x20026;

size_t length(const char* text) {
  size_t count = 0;
  while (text[count] != '\0') ++count;
  return count;
}

}  // namespace

void semihosting::print(const char* text) {
  cpu::ask_debugger(sys_write0, text);
}

intptr_t semihosting::open_to_read(const char* name) {
  const uintptr_t arguments[] = {reinterpret_cast<uintptr_t>(name), mode_read_binary, length(name)};
  return static_cast<intptr_t>(cpu::ask_debugger(sys_open, arguments));
}

size_t semihosting::read(intptr_t file, void* bytes, size_t count) {
  const uintptr_t arguments[] = {static_cast<uintptr_t>(file), reinterpret_cast<uintptr_t>(bytes),
                                 count};
  return count - cpu::ask_debugger(sys_read, arguments);  // unread bytes
}

void semihosting::exit(int code) {
  const uintptr_t arguments[] = {application_exit, static_cast<uintptr_t>(code)};
  for (;;) cpu::ask_debugger(sys_exit_extended, arguments);
}
