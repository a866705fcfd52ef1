# Reads GCC's call graphs (-fcallgraph-info=su) of several files as one. Fails on recursion and on a
# frame without a bound. Otherwise prints the largest stack of every function in bytes, with all that it
# calls, and its name for the linker.
#
# What is called by a pointer, as a sink is, counts as nothing, or as the bytes given with
# -v called_by_pointer=BYTES. The helpers of libgcc and the memory functions, whose frames are not
# known either, count as the deepest of them.

# A local function carries its file in its title. Without it functions of one name fall together,
# which can show a circle that is not there but never hide one.
function plain(title) {
  sub(/^.*:/, "", title)
  return title
}

# Marks: 1 on the way down, 2 done.
function visit(f,    count, called, i) {
  mark[f] = 1
  deepest[f] = 0
  count = split(calls[f], called, " ")
  for (i = 1; i <= count; i++) {
    if (mark[called[i]] == 1) {
      print "recursion: " label[called[i]] ", by way of " label[f]
      bad = 1
    } else {
      if (!mark[called[i]]) visit(called[i])
      if (deepest[called[i]] > deepest[f]) deepest[f] = deepest[called[i]]
    }
  }
  deepest[f] += frame[f]
  mark[f] = 2
}

BEGIN {
  FS = "\""
  helper_frame = 32  # __aeabi_lmul of the Cortex-M0+: 28
}

$1 ~ /^node/ {
  f = plain($2)
  if (split($4, part, /\\n/) == 3) {  # defined here: signature, place, "8 bytes (static)"
    label[f] = part[1]
    bytes = part[3] + 0
    if (!is_defined[f] || bytes > frame[f]) frame[f] = bytes
    is_defined[f] = 1
    if (part[3] ~ /dynamic\)/) {
      print "not bounded: " part[1]
      bad = 1
    }
    defined++
  } else if (!(f in label)) {
    label[f] = f
    frame[f] = f == "__indirect_call" ? called_by_pointer + 0 : helper_frame
  }
}

$1 ~ /^edge/ {
  f = plain($2)
  calls[f] = calls[f] " " plain($4)
}

END {
  if (defined == 0) {
    print "no function found"
    exit 1
  }
  for (f in label)
    if (!mark[f]) visit(f)
  if (bad) exit 1
  for (f in is_defined) print deepest[f] "\t" f
}
