/* Preloaded into the program DOUBLING_PROGRAM: calls its main() once per line of the file
 * DOUBLING_CASES, whose words are separated by tabs. Every call is made by counted(), which callgrind
 * counts alone. Writes the exit codes to the file DOUBLING_CODES. */
#define _GNU_SOURCE
#include <dlfcn.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

typedef int (*main_function)(int, char **, char **);
typedef int (*start_function)(main_function, int, char **, void (*)(void), void (*)(void),
                              void (*)(void), void *);

static main_function real_main;

__attribute__((noinline)) int counted(int count, char **words, char **environment) {
  return real_main(count, words, environment);
}

static int repeated_main(int count, char **words, char **environment) {
  enum { max_words = 200, max_line = 1 << 20 };
  static char line[max_line];
  FILE *cases = fopen(getenv("DOUBLING_CASES"), "r"), *codes = fopen(getenv("DOUBLING_CODES"), "w");
  if (!cases || !codes || count < 1) return 1;
  while (fgets(line, max_line, cases)) {
    char *of_case[max_words + 1] = {words[0]};
    int words_of_case = 1;
    line[strcspn(line, "\n")] = 0;
    for (char *word = strtok(line, "\t"); word && words_of_case < max_words; word = strtok(0, "\t"))
      of_case[words_of_case++] = word;
    fprintf(codes, "%d\n", counted(words_of_case, of_case, environment));
    fflush(codes);
  }
  return 0;
}

int __libc_start_main(main_function main, int count, char **words, void (*init)(void),
                      void (*fini)(void), void (*rtld_fini)(void), void *stack_end) {
  start_function start = (start_function)dlsym(RTLD_NEXT, "__libc_start_main");
  const char *program = getenv("DOUBLING_PROGRAM");
  const int is_it = program && count > 0 && strcmp(words[0], program) == 0;
  real_main = main;
  return start(is_it ? repeated_main : main, count, words, init, fini, rtld_fini, stack_end);
}
