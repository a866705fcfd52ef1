# Figures, one a line (group, name, column, value, with tabs between), as tables: a row a name, in the
# order of their first mention. Groups with the same columns share a table. -v markdown=1: Markdown.

BEGIN { FS = "\t" }

{
  if (!($1 in columns)) group[++groups] = $1
  if (!(($1, $2) in named)) rows[$1] = rows[$1] FS $2
  if (!(($1, $3) in headed)) columns[$1] = columns[$1] FS $3
  named[$1, $2] = headed[$1, $3] = 1
  value[$1, $2, $3] = $4
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

# line(KIND, NAME, CELLS, COUNT): the first cell is the second of the array.
function line(kind, name, cells, count,    i, text) {
  if (!markdown) {
    text = sprintf("%-36s", (kind == "row" ? "  " : "") name)
    for (i = 2; i <= count; i++) text = text sprintf("%15s", cells[i])
  } else {
    gsub(/^ +/, "", name)
    text = "| " (kind == "group" ? "**" name "**" : name) " |"
    for (i = 2; i <= count; i++) text = text " " cells[i] " |"
  }
  sub(/ +$/, "", text)
  print text
}

function table_head(heads, count,    i, text) {
  line("head", "", heads, count)
  if (!markdown) return
  text = "|---|"
  for (i = 2; i <= count; i++) text = text "--:|"
  print text
}

function group_rows(g, heads, count,    names, n, i, c, cells) {
  split("", cells)
  line("group", g, cells, markdown ? count : 0)
  n = split(rows[g], names, FS)
  for (i = 2; i <= n; i++) {
    for (c = 2; c <= count; c++) cells[c] = grouped(value[g, names[i], heads[c]])
    line("row", names[i], cells, count)
  }
}

END {
  for (i = 1; i <= groups; i++) {
    g = group[i]
    count = split(columns[g], heads, FS)
    if (columns[g] != shown) {
      if (shown) print ""
      table_head(heads, count)
    }
    shown = columns[g]
    group_rows(g, heads, count)
  }
}
