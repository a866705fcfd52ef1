#!/bin/bash -eu
# Builds every fuzz target into $OUT, with its seeds and its dictionary, as OSS-Fuzz asks: with the
# compilers, flags and fuzzing engine of the environment. Runs in the folder of the sources.

# Where the targets run there are no libraries but the system's own.
static() { find /usr/lib -name "lib$1.a" -print -quit; }

# OSS-Fuzz names this check, which needs the type information that the library is built without.
export CXXFLAGS="$CXXFLAGS -fno-sanitize=vptr"

build=${WORK:-/tmp}/discmc
cmake -S . -B "$build" -DCMAKE_BUILD_TYPE=None -DDISCMC_FUZZING_ENGINE="$LIB_FUZZING_ENGINE" \
  -DDISCMC_BUILD_COMMAND=OFF -DDISCMC_BUILD_EXAMPLES=OFF -DDISCMC_BUILD_TESTS=OFF \
  -DZLIB_LIBRARY="$(static z)"
cmake --build "$build" -j "$(nproc)"

for corpus in fuzz/corpus/*; do
  name=${corpus##*/}
  cp "$build/fuzz/fuzz_$name" "$OUT/"
  zip -q -j "$OUT/fuzz_${name}_seed_corpus.zip" "$corpus"/*
  if [[ -f fuzz/$name.dict ]]; then cp "fuzz/$name.dict" "$OUT/fuzz_$name.dict"; fi
done
