# page.awk RECORD PAGE: prints the page with what it shows of the record put between its marks
#   <!-- footprint: NAME -->  and  <!-- end -->
# NAME is a group of the record, which becomes a table, or `compilers`, or `summary`. The record has a
# figure a line: group, name, column, value, with tabs between them; rows and columns of a table come
# in the order of their first mention.

BEGIN { FS = "\t" }

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
  head = "CT head, 256x256x113, at 500"
  slices = "slices, first is key"
  print "| | polygons | thresholded slices |"
  print "|---|--:|--:|"
  bytes_row("flash", figure("Payloads", target ": flash", "regions"), \
    figure("Payloads", target ": flash", slices))
  bytes_row("stack, at most", figure("Stack", "Extractor16 into an Encoder", target), \
    figure("Stack", "SliceEncoder::push()", target))
  bytes_row("RAM, least", figure("RAM", "Extractor16", "bytes") + figure("RAM", "Encoder", "bytes") \
    + figure("Arena", "256x256", "extractor, least"), \
    figure("Payloads", "RAM for slices of 256x256", slices))
  bytes_row("RAM as measured here", figure("Payloads", "RAM for slices of 256x256", "regions"), \
    figure("Payloads", "RAM for slices of 256x256", slices))
  bytes_row("stream", figure("Payloads", "bytes: " head, "regions"), \
    figure("Payloads", "bytes: " head, slices))
  print "| instructions per voxel | " \
    grouped(figure("Payloads", target ": instructions a voxel, CT head", "regions")) " | " \
    grouped(figure("Payloads", target ": instructions a voxel, CT head", slices)) " |"
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

/^<!-- footprint: .* -->$/ {
  inside = 1
  marks++
  name = substr($0, 17, length($0) - 20)
  if (name == "compilers") print "Compilers: " compilers "."
  else if (name == "summary") print_summary()
  else if (name in names_of) print_table(name)
  else fail("no figures named '" name "'")
}

END {
  if (failed) exit 1
  if (!marks || inside) fail("no mark, or one without an end")
}
