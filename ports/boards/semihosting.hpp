// Semihosting: files, a console and an exit code, provided by the debugger or by QEMU.
//
// Without them, a request is a fault. A port to a stand-alone board replaces the users of this
// header: board.cpp, and the file as the source of rows.
#pragma once

#include <stddef.h>
#include <stdint.h>

namespace semihosting {

void print(const char* text);

/// Returns the number of a file to read; negative if it cannot be opened.
intptr_t open_to_read(const char* name);

/// Reads up to `count` bytes; fewer at the end of the file. Returns their number.
size_t read(intptr_t file, void* bytes, size_t count);

[[noreturn]] void exit(int code);

}  // namespace semihosting
