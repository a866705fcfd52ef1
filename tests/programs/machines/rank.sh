#!/usr/bin/env bash
# rank.sh VOLUME OPTION...: the work of one rank of an MPI program. It extracts its slab into the working folder, which
# all ranks share. Slabs are joined in a tree: 0 and 1, 2 and 3, then both results. The joined stream is joined.dmc. No
# messages are needed, because a stream gets its name only when it is complete.
set -euo pipefail
rank=$OMPI_COMM_WORLD_RANK
ranks=$OMPI_COMM_WORLD_SIZE
incomplete=3 # the exit code of a join with missing slabs

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
