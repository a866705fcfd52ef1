# source.awk RECORD SOURCE: prints cycle_costs.cpp with the recorded costs between its marks.

BEGIN {
  FS = "\t"
  cores = split("cortex-m0plus cortex-m4 cortex-m7", core, " ")
}

function costs(group, core,    i, text) {
  for (i = 1; i <= terms; i++) text = text (i > 1 ? ", " : "") value[group, term[i], core]
  return "{" text "}"
}

FNR == NR {
  if ($1 == "Costs of regions" && $3 == core[1]) term[++terms] = $2
  value[$1, $2, $3] = $4
  next
}

/^ *\/\/ end$/ { inside = 0 }
!inside { print }
/^ *\/\/ begin$/ {
  inside = 1
  for (c = 1; c <= cores; c++) {
    print "    {" costs("Costs of regions", core[c]) ","
    print "     " costs("Costs of slices", core[c]) "},"
  }
}
