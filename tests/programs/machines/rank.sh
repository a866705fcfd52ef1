#!/usr/bin/env bash
# rank.sh VOLUME OPTION...: what a rank of an MPI program does. It extracts its slab into the working
# folder, which all ranks share. The slabs are joined in a tree: those of ranks 0 and 1, and of 2 and 3,
# then both. The stream of all is joined.dmc. No message is needed: a stream appears under its name
# when it is complete.
set -euo pipefail
rank=$OMPI_COMM_WORLD_RANK
ranks=$OMPI_COMM_WORLD_SIZE
incomplete=3 # the exit code of a join that misses slabs

join() {
  local code=0
  "$DISCMC" join "$@" -q 2>"$rank.log" || code=$?
  [[ $code -eq 0 || $code -eq $incomplete ]] || { cat "$rank.log" >&2; exit $code; }
}

"$DISCMC" extract "$@" --slab "$((rank + 1))/$ranks" --allow-empty -q -o "$rank.of1.dmc"
for ((of = 1; of < ranks && rank % (2 * of) == 0; of *= 2)); do
  mine=$rank.of$of.dmc theirs=$((rank + of)).of$of.dmc
  if [[ $((rank + of)) -lt $ranks ]]; then
    until [[ -e $theirs ]]; do sleep 0.05; done
    join "$mine" "$theirs" -o "$rank.of$((2 * of)).dmc"
  else
    mv "$mine" "$rank.of$((2 * of)).dmc"
  fi
done
[[ $rank -ne 0 ]] || mv "0.of$of.dmc" joined.dmc
