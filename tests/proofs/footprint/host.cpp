// Runs the counted work on the host, only for its results.
#include <stdio.h>
#include <stdlib.h>
#include <board.hpp>

#include "marks.hpp"

void board::report(const char* name, uint32_t value) {
  printf("%s %lu\n", name, static_cast<unsigned long>(value));
}

void board::stop(bool succeeded) {
  exit(succeeded ? EXIT_SUCCESS : EXIT_FAILURE);
}

void count_on() {}
void count_off() {}
void count_report() {}
