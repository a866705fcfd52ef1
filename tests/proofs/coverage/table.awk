# The table of scripts/check/coverage, from explanations (unreached.txt) and the output of `llvm-cov show`:
# lines and branches by file. Below it is every line and every way of a branch that was never taken.
# A branch is taken if it is in any instantiation of its template. The exit code is 1 if something was
# not taken that is not explained, or was taken that is.

FNR == NR {
  if (/^#/) next
  split($0, part, "\t")
  excuse[part[1] ": " part[2]] = part[3]
  next
}

/^\/.*:$/ {
  file = $0
  sub(/.*\//, "", file)
  sub(/:$/, "", file)
  order[++file_count] = file
  next
}

# "   12|  1.5k|  text"; there is no count where there is no code.
/^ +[0-9]+\| / {
  split($0, column, "|")
  number = column[1] + 0
  text = substr($0, length(column[1] column[2]) + 3)
  sub(/^ +/, "", text)
  source[file, number] = text
  if (column[2] !~ /[0-9]/) next
  ++lines[file]
  if (column[2] ~ /^ *0$/) miss(file, number, "never executed")
  else ++lines_taken[file]
  next
}

# "  |  Branch (12:7): [True: 3, False: 0]"; folded where a constant decides.
/Branch \([0-9:]+\): \[True: / {
  place = $0
  sub(/.*Branch \(/, "", place)
  sub(/\).*/, "", place)
  see("true", $0 !~ /True: 0,/)
  see("false", $0 !~ /False: 0\]/)
}

function see(way, is_taken, key) {
  key = file ":" place ":" way
  if (!(key in taken)) {
    branch[++branch_count] = key
    ++branches[file]
    taken[key] = 0
  }
  if (is_taken) taken[key] = 1
}

function miss(file, number, what, line) {
  line = file ": " source[file, number]
  if (line in excuse) {
    what = what " (" excuse[line] ")"
    is_used[line] = 1
  } else ++failures
  missed[++missed_count] = sprintf("%s:%d: %s: %s", file, number, what, source[file, number])
}

function share(part, all) {
  return all == 0 ? "-" : sprintf("%.2f %%", int(10000 * part / all) / 100)
}

function row(name, lines, lines_taken, branches, branches_taken) {
  printf "%-20s %6d %7d %9s %9d %7d %9s\n", name, lines, lines - lines_taken,
    share(lines_taken, lines), branches, branches - branches_taken, share(branches_taken, branches)
}

END {
  for (i = 1; i <= branch_count; ++i) {
    split(branch[i], part, ":")
    if (taken[branch[i]]) ++branches_taken[part[1]]
    else miss(part[1], part[2] + 0, "column " part[3] " never " part[4])
  }
  printf "%-20s %6s %7s %9s %9s %7s\n", "file", "lines", "missed", "", "branches", "missed"
  for (i = 1; i <= file_count; ++i) {
    file = order[i]
    if (lines[file] == 0) continue
    row(file, lines[file], lines_taken[file], branches[file], branches_taken[file])
    all_lines += lines[file]
    all_lines_taken += lines_taken[file]
    all_branches += branches[file]
    all_branches_taken += branches_taken[file]
  }
  row("all", all_lines, all_lines_taken, all_branches, all_branches_taken)
  for (i = 1; i <= missed_count; ++i) print missed[i]
  for (line in excuse)
    if (!(line in is_used)) {
      print "is taken, against what unreached.txt says: " line
      ++failures
    }
  exit failures > 0
}
