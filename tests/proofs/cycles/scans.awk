# scans.awk -v taken=CYCLES WORK COSTS COUNTS: prints the work and the cost of each scan. A line has:
# name, regions or slices, voxels of 8 and of 16 bits, voxels that are on, rows, cells, steps, bytes,
# cycles, instructions.
#   WORK    the scans in their order
#   COSTS   the cycles of each block
#   COUNTS  how often each block ran
#   taken   the cycles that a branch adds if it is taken

FILENAME == ARGV[1] {
  if ($1 ~ /^(fit|test|real)_/) name = $1 ($1 == "real_CT_head" ? "_(Stanford)" : "")
  else if ($1 == "voxels_8") {
    scan[++scans] = name (name == last ? " slices" : " regions")
    last = name
  }
  if ($1 ~ /^(voxels_|on$|rows|cells|steps|bytes)/) scan[scans] = scan[scans] " " $2
  next
}
FILENAME == ARGV[2] {
  cost[$1, $2] = $3
  next
}
$1 == "end" {
  printf "%s %.0f %.0f\n", scan[++ended], cycles, instructions
  cycles = instructions = 0
  next
}
{
  cycles += $3 * cost[$1, $2] + $4 * taken
  instructions += $3 * $2
}
END {
  if (!scans || ended != scans) {
    print "the counted scans are not complete" > "/dev/stderr"
    exit 1
  }
}
