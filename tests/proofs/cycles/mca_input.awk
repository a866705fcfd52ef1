# mca_input.awk DISASSEMBLY COUNTS: the blocks that ran as llvm-mca takes them, a region each, named by
# the first address and the number of instructions. Where branches lead does not matter.

BEGIN { FS = "\t" }

# A call is one, too: llvm-mca would take its callee for 100 cycles.
function is_branch(name) {
  return name ~ /^(b|bl|bx|blx)$/ || name ~ /^b(eq|ne|cs|cc|mi|pl|vs|vc|hi|ls|ge|lt|gt|le)$/
}
# In an IT block, within which a block may begin; LLVM's model of the Cortex-M7 lacks IT itself.
function unconditional(name) {
  sub(/(eq|ne|cs|cc|mi|pl|vs|vc|hi|ls|ge|lt|gt|le)$/, "", name)
  return name
}
function first_of(operands) { return substr(operands, 1, index(operands, ",")) }

function instruction(name, operands) {
  if (is_branch(name)) return (name ~ /^bl?x?$/ ? "b" : name) " elsewhere"
  if (name ~ /^cbn?z$/) return name " " first_of(operands) " elsewhere"
  if (name ~ /^add/ && operands ~ /, pc, #/) return "adr " first_of(operands) " elsewhere"
  return name " " operands
}

FNR == NR && /^ *[0-9a-f]+:\t/ {
  address = $1
  gsub(/[ :]/, "", address)
  at[address] = ++instructions
  sub(/[.][nw]$/, "", $2)  # which of two encodings
  name[instructions] = conditional-- > 0 ? unconditional($2) : $2
  if ($2 ~ /^it[te]*$/) conditional = length($2) - 1
  operands[instructions] = $3
  sub(/ *[;@<].*/, "", operands[instructions])
}
FNR == NR { next }

{ split($0, block, " ") }
block[1] == "end" || (block[1], block[2]) in told { next }
{
  told[block[1], block[2]] = 1
  print "# LLVM-MCA-BEGIN " block[1] "_" block[2]
  for (i = at[block[1]]; i < at[block[1]] + block[2]; i++)
    if (name[i] !~ /^it[te]*$/) print instruction(name[i], operands[i])
  print "# LLVM-MCA-END"
}
