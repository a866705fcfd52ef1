# page.awk RECORD PAGE: prints the page with what it shows of the record put between its marks
#   <!-- footprint: NAME -->  and  <!-- end -->
# With -v record=cycles the marks are <!-- cycles: NAME -->: a page may show two records.
# NAME is a group of the record, which becomes a table, or `compilers`, `summary`, `requirements` or
# `requirements of RAM`. The record has a figure per line: group, name, column, value, with tabs between
# them. Rows and columns of a table come in the order of their first mention.

BEGIN {
  FS = "\t"
  if (!record) record = "footprint"
  mark = "<!-- " record ": "
}

# 1234567.8 as 1,234,567.8
function grouped(number,    whole, rest) {
  whole = number
  sub(/[.].*/, "", whole)
  rest = substr(number, length(whole) + 1)
  for (; length(whole) > 3; whole = substr(whole, 1, length(whole) - 3))
    rest = "," substr(whole, length(whole) - 2) rest
  return whole rest
}

function fail(why) {
  print FILENAME ": " why > "/dev/stderr"
  failed = 1
  exit 1
}

function figure(group, name, column) {
  if (!((group, name, column) in value)) fail("no figure '" group ", " name ", " column "'")
  return value[group, name, column]
}

# The first element of a list (names, heads) is empty.
function print_table(group,    names, rows, heads, columns, i, c, text, rule) {
  rows = split(names_of[group], names, FS)
  columns = split(heads_of[group], heads, FS)
  text = "| |"
  rule = "|---|"
  for (c = 2; c <= columns; c++) {
    text = text " " heads[c] " |"
    rule = rule "--:|"
  }
  print text
  print rule
  for (i = 2; i <= rows; i++) {
    text = "| " names[i] " |"
    for (c = 2; c <= columns; c++) text = text " " grouped(figure(group, names[i], heads[c])) " |"
    print text
  }
}

function bytes_row(name, of_polygons, of_slices) {
  print "| " name " | " grouped(of_polygons) " bytes | " grouped(of_slices) " bytes |"
}

function print_summary(    target, head, slices) {
  target = "Cortex-M4 -Os"
  head = "CT head (Stanford), 256x256x113, at 500"
  slices = "slices, first is key"
  print "| | polygons | thresholded slices |"
  print "|---|--:|--:|"
  bytes_row("flash", figure("Kinds of stream", target ": flash", "regions"), \
    figure("Kinds of stream", target ": flash", slices))
  bytes_row("stack, at most", figure("Stack", "Extractor16 into an Encoder", target), \
    figure("Stack", "SliceEncoder::push()", target))
  bytes_row("RAM, least", figure("RAM", "Extractor16", "bytes") + figure("RAM", "Encoder", "bytes") \
    + figure("Arena", "256x256", "extractor, least"), \
    figure("Kinds of stream", "RAM for slices of 256x256", slices))
  bytes_row("RAM for the lines below", figure("Kinds of stream", "RAM for slices of 256x256", "regions"), \
    figure("Kinds of stream", "RAM for slices of 256x256", slices))
  bytes_row("stream", figure("Kinds of stream", "bytes: " head, "regions"), \
    figure("Kinds of stream", "bytes: " head, slices))
  print "| instructions per voxel | " \
    grouped(figure("Kinds of stream", target ": instructions per voxel, CT head (Stanford)", "regions")) " | " \
    grouped(figure("Kinds of stream", target ": instructions per voxel, CT head (Stanford)", slices)) " |"
}

# What a device needs to send either kind of stream.
function print_requirements(    i, t, cores, targets, part, text) {
  cores = split("Cortex-M0+|Cortex-M4|RV32IMAC", targets, "|")
  print "| | Cortex-M0+ | Cortex-M4 | RV32IMAC |"
  print "|---|--:|--:|--:|"
  split("sends polygons: flash|Flash|sends polygons: the three above|" \
    "sends polygons, lean: flash|Lean|LeanExtractor16|" \
    "sends polygons: stack|Stack|Extractor16 into an Encoder|" \
    "sends thresholded slices: flash|Flash|slice encoder of 8-bit samples|" \
    "sends thresholded slices: stack|Stack|SliceEncoder::push()", part, "|")
  for (i = 1; i <= 15; i += 3) {
    text = "| " part[i] " |"
    for (t = 1; t <= cores; t++)
      text = text " " grouped(figure(part[i + 1], part[i + 2], targets[t] " -Os")) " |"
    print text
  }
}

# Objects and arena together, by the size of a slice.
function print_requirements_of_ram(    i, sizes, size, polygons, slices) {
  polygons = figure("RAM", "Extractor16", "bytes") + figure("RAM", "Encoder", "bytes")
  slices = figure("RAM", "SliceEncoder", "bytes")
  print "| | polygons, least | thresholded slices | key slices only |"
  print "|---|--:|--:|--:|"
  sizes = split(names_of["Arena"], size, FS)
  for (i = 2; i <= sizes; i++)
    print "| " size[i] " | " grouped(polygons + figure("Arena", size[i], "extractor, least")) " | " \
      grouped(slices + figure("Arena", size[i], "slice encoder")) " | " \
      grouped(slices + figure("Arena", size[i], "key slices only")) " |"
}

# ---- the record ----

FNR == NR && /^# / {
  compilers = compilers (compilers ? " and " : "") substr($0, 3)
  next
}

FNR == NR {
  if (!(($1, "name", $2) in seen)) names_of[$1] = names_of[$1] FS $2
  if (!(($1, "head", $3) in seen)) heads_of[$1] = heads_of[$1] FS $3
  seen[$1, "name", $2] = seen[$1, "head", $3] = 1
  value[$1, $2, $3] = $4
  next
}

# ---- the page ----

/^<!-- end -->$/ { inside = 0 }
!inside { print }

index($0, mark) == 1 && / -->$/ {
  inside = 1
  marks++
  name = substr($0, length(mark) + 1, length($0) - length(mark) - 4)
  if (name == "compilers") print "Compilers: " compilers "."
  else if (name == "summary") print_summary()
  else if (name == "requirements") print_requirements()
  else if (name == "requirements of RAM") print_requirements_of_ram()
  else if (name in names_of) print_table(name)
  else fail("no figures named '" name "'")
}

END {
  if (failed) exit 1
  if (!marks || inside) fail("no mark, or one without an end")
}
