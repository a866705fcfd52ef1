// The unit tests with every mutant of the library. Environment: MUTANT=17 activates a mutant;
// MUTANTS_REACHED=file names the file for the time and the numbers of the evaluated mutants.
#define DOCTEST_CONFIG_IMPLEMENT
// A crash must end the process at once. doctest's handler could wait forever for a lock of malloc.
#define DOCTEST_CONFIG_NO_POSIX_SIGNALS
#include <doctest/doctest.h>
#include <stdio.h>
#include <stdlib.h>
#include <time.h>

namespace {

// Runs before all else, because constants of tests call the library.
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
