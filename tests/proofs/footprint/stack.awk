# Selects the stack of the public functions from that of all functions (call_graph.awk) and their names
# (c++filt -p). Functions that share a name count as the deepest of them. Fails if one is missing.

function want(class, names,    count, name, i) {
  count = split(names, name, " ")
  for (i = 1; i <= count; i++) wanted[++functions] = class name[i]
}

BEGIN {
  FS = OFS = "\t"
  want("Extractor16::", "start reset push push_bits skip_row resume finish abandon")
  want("Encoder::", "start accept flush")
  want("SliceEncoder::", "start push push_bits skip_row resume flush finish abandon")
  want("Decoder::", "start push finish")
  want("", "ring_vertices twice_area split_ring is_corner")
}

{
  name = $2
  sub(/^discmc::/, "", name)
  sub(/BasicExtractor<unsigned short, discmc::detail::trace::BitIntake, discmc::detail::trace::Sweep<unsigned short, discmc::detail::trace::NoNormal, false> >/, "Extractor16", name)
  sub(/push_row_of_bits/, "push_bits", name)
  sub(/push_samples/, "push", name)
  sub(/<.*$/, "", name)
  if (!(name in most) || $1 > most[name]) most[name] = $1
}

END {
  for (i = 1; i <= functions; i++) {
    if (!(wanted[i] in most)) {
      print "no function " wanted[i] > "/dev/stderr"
      exit 1
    }
    print wanted[i] "()", most[wanted[i]]
  }
}
