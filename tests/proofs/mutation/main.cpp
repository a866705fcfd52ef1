// The unit tests with every mutant of the library in them. The environment selects the active one
// (MUTANT=17), and the file for the time and the numbers of the evaluated mutants
// (MUTANTS_REACHED=file).
#define DOCTEST_CONFIG_IMPLEMENT
// A mutant that crashes is to die at once: doctest's handler may wait for ever for a lock of
// malloc.
#define DOCTEST_CONFIG_NO_POSIX_SIGNALS
#include <doctest/doctest.h>
#include <stdio.h>
#include <stdlib.h>
#include <time.h>

namespace {

// Before anything else runs, as tests have constants that call the library.
__attribute__((constructor(101))) void choose_mutant() {
  if (const char* mutant = getenv("MUTANT"))
    mutation::active = static_cast<unsigned>(strtoul(mutant, nullptr, 10));
}

bool write_reached(const char* path) {
  FILE* file = fopen(path, "w");
  if (file == nullptr) return false;
  fprintf(file, "%f\n", static_cast<double>(clock()) / CLOCKS_PER_SEC);
  for (unsigned id = 0; id < mutation::most; ++id)
    if (mutation::reached[id] != 0) fprintf(file, "%u\n", id);
  return fclose(file) == 0;
}

}  // namespace

int main(int argc, char** argv) {
  const int failed = doctest::Context(argc, argv).run();
  const char* path = getenv("MUTANTS_REACHED");
  return failed != 0 || (path != nullptr && !write_reached(path)) ? 1 : 0;
}
