# fit.awk -v core=NAME SCANS: prints the cost of a unit of work, as regions and as slices, from the
# lines of scans.awk. Also prints the errors of the scans that were not fitted. A figure a line: group,
# name, column, value, with tabs between them.
#
# The cost of every voxel and row comes from the scans without a surface alone, so that it is right for
# rows of any width. A voxel that is on costs slices as much more as regions. The rest is fitted by least
# squares of relative errors, so that a small scan counts as much as a large one. A term whose cost would be negative is left out, and the others are fitted anew.

BEGIN {
  OFS = "\t"
  terms = split("a voxel of 8 bits|a voxel of 16 bits|a voxel that is on, more|a row|an active cell|a link (slices: a step)|a byte", term, "|")
  floor_terms = 4
  on = 3
}

{
  payload = $2
  scan = $1
  sub(/^[a-z]*_/, "", scan)
  gsub(/_/, " ", scan)
  n = ++scans[payload]
  purpose[payload, n] = substr($1, 1, index($1, "_") - 1)
  name[payload, n] = scan
  for (t = 1; t <= terms; t++) work[payload, n, t] = $(t + 2)
  cycles[payload, n] = $10
}

function is_floor(payload, n) {
  return name[payload, n] ~ (payload == "slices" ? "^(empty|narrow)" : "^(empty|narrow|full)")
}

# What the terms of which the cost is known take of a scan.
function known_of(payload, n,    t, sum) {
  for (t = 1; t <= terms; t++) if (is_known[t]) sum += work[payload, n, t] * cost[t]
  return sum
}

# Solves the normal equations of the terms that are in use, by Gauss and Jordan.
function solve(payload, of_floor,    i, j, k, n, pivot, factor, weight) {
  split("", matrix)
  for (n = 1; n <= scans[payload]; n++) {
    if (purpose[payload, n] != "fit" || is_floor(payload, n) != of_floor) continue
    weight = 1 / cycles[payload, n]
    for (i = 1; i <= terms; i++) {
      for (j = 1; j <= terms; j++)
        matrix[i, j] += work[payload, n, i] * weight * work[payload, n, j] * weight
      matrix[i, terms + 1] += work[payload, n, i] * weight * (1 - known_of(payload, n) * weight)
    }
  }
  for (i = 1; i <= terms; i++)
    if (!is_used[i]) {
      for (j = 1; j <= terms; j++) matrix[i, j] = matrix[j, i] = 0
      matrix[i, i] = 1
      matrix[i, terms + 1] = 0
    }
  for (k = 1; k <= terms; k++) {
    pivot = matrix[k, k]
    for (j = k; j <= terms + 1; j++) matrix[k, j] /= pivot
    for (i = 1; i <= terms; i++) {
      if (i == k) continue
      factor = matrix[i, k]
      for (j = k; j <= terms + 1; j++) matrix[i, j] -= factor * matrix[k, j]
    }
  }
  for (i = 1; i <= terms; i++) if (is_used[i]) cost[i] = matrix[i, terms + 1]
}

function fit(payload,    i, least) {
  for (i = 1; i <= terms; i++) {
    is_known[i] = payload == "slices" && i == on
    if (!is_known[i]) cost[i] = 0
    is_used[i] = i <= floor_terms && !is_known[i]
  }
  solve(payload, 1)
  for (i = 1; i <= terms; i++) {
    is_known[i] = i <= floor_terms
    is_used[i] = i > floor_terms && !(payload == "slices" && term[i] == "an active cell")
  }
  do {
    solve(payload, 0)
    least = 0
    for (i = 1; i <= terms; i++)
      if (is_used[i] && cost[i] < 0 && (!least || cost[i] < cost[least])) least = i
    if (least) is_used[least] = cost[least] = 0
  } while (least)
}

function error_of(payload, n,    t, sum) {
  for (t = 1; t <= terms; t++) sum += work[payload, n, t] * cost[t]
  return 100 * (sum / cycles[payload, n] - 1)
}

function absolute(value) { return value < 0 ? -value : value }

function report(payload,    t, n, error, worst) {
  fit(payload)
  for (t = 1; t <= terms; t++) print "Costs of " payload, term[t], core, sprintf("%.4g", cost[t])
  for (n = 1; n <= scans[payload]; n++) {
    error = error_of(payload, n)
    if (purpose[payload, n] != "fit") print "Errors", name[payload, n] ", " payload, core, sprintf("%+.1f", error)
    else if (!is_floor(payload, n) && absolute(error) > absolute(worst)) worst = error
  }
  print "Errors", "fitted, at worst, " payload, core, sprintf("%+.1f", worst)
}

END {
  report("regions")
  report("slices")
}
