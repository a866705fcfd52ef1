# timings.awk -v core=NAME DISASSEMBLY COUNTS: the cycles of each block that ran, on a Cortex-M0+ or a
# Cortex-M4 without wait states. A line has: first address, number of instructions, cycles. A branch that
# is taken adds cycles that are not included: see `taken` of scripts/check/cycles.
#
# The tables are in the Technical Reference Manuals of Arm, "Instruction set summary":
#   Cortex-M0+  DDI 0484, table 3-1; with the fast multiplier
#   Cortex-M4   DDI 0439, table 3-1, and "Load/store timings"
# A division counts as 7 cycles of 2 to 12. Not distinguished: an address that depends on the
# instruction before, which costs a Cortex-M4 a cycle more, and skipped instructions of an IT block.

BEGIN { FS = "\t" }

# How many registers the braces hold.
function registers(operands) {
  sub(/.*{/, "", operands)
  return gsub(/,/, "", operands) + 1
}

# Only single loads are pipelined, with a load or a store behind them.
function is_single_load(name) { return name ~ /^ldr/ && name !~ /^ldrd/ }

function of_m0plus(name, operands) {
  if (name ~ /^(ldm|stm|push|pop)/) return 1 + registers(operands) + (operands ~ /pc/)
  if (name ~ /^(ldr|str)/) return 2
  if (name == "bl") return 2
  return 1
}

function of_m4(name, operands, before) {
  if (name ~ /^(ldm|stm|push|pop)/) return 1 + registers(operands)
  if (name ~ /^(ldrd|strd)/) return 3
  if (is_single_load(name)) return (is_single_load(before) ? 1 : 2) + (operands ~ /^pc/)
  if (name ~ /^str/) return operands ~ /\[r[0-9]+, r/ && !is_single_load(before) ? 2 : 1
  if (name ~ /^tb[bh]/) return 4
  if (name ~ /^[su]div/) return 7
  if (name ~ /^ml[as]/) return 2
  return 1
}

function cycles_of(first, count,    i, before, sum) {
  for (i = first; i < first + count; i++) {
    sum += core == "cortex-m0plus" ? of_m0plus(name[i], operands[i]) : of_m4(name[i], operands[i], before)
    before = name[i]
  }
  return sum
}

FNR == NR && /^ *[0-9a-f]+:\t/ {
  address = $1
  gsub(/[ :]/, "", address)
  at[address] = ++instructions
  sub(/[.][nw]$/, "", $2)
  name[instructions] = $2
  operands[instructions] = $3
}
FNR == NR { next }

{ split($0, block, " ") }
block[1] == "end" || (block[1], block[2]) in told { next }
{
  told[block[1], block[2]] = 1
  if (!(block[1] in at)) {
    print "no instruction at " block[1] > "/dev/stderr"
    exit 1
  }
  print block[1], block[2], cycles_of(at[block[1]], block[2])
}
