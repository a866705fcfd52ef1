# filter.awk FILE: a header as Doxygen wants it. The comments of a header are its manual as they stand:
#   the one at its top is of the file;
#   in C those before a declaration and behind a member are documentation, too;
#   a comment before several declarations in a row, without an empty line between, is of them all.
# What is indented in a comment is a drawing or code. Lines move: what Doxygen reports at a line belongs a few above.

function is_c() { return FILENAME ~ /[.]h$/ }

# A line of the file's comment, without its marks.
function head_line(text) {
  match(text, /^ */)
  if (text !~ /[^ ]/) {
    empty_lines++
    return
  }
  if (in_drawing && RLENGTH <= 1) print "~~~"
  for (; empty_lines > 0; empty_lines--) print ""
  if (!in_drawing && RLENGTH > 1) print "~~~{.txt}"
  in_drawing = RLENGTH > 1
  print substr(text, 2)
}

function end_head() {
  if (in_drawing) print "~~~"
  print "*/"
  head = 0
}

# The text between two empty lines. Declarations end at the left margin.
function print_paragraph(    i, is_told_once) {
  is_told_once = declarations > 1 && paragraph[0] ~ /^\/\*\*/
  if (is_told_once) print "/** @{ */"
  for (i = 0; i < lines; i++) print paragraph[i]
  if (is_told_once) print "/** @} */"
  lines = declarations = 0
}

FNR == 1 {
  print "/** \\file"
  head = 1
}

head && is_c() {
  ends = sub(/ *\*\/$/, "")
  sub(/^ ?\/?\*/, "")
  head_line($0)
  if (ends) end_head()
  next
}

head && /^\/\// {
  head_line(substr($0, 3))
  next
}

head { end_head() }

# Friends have no place in the reference, and source pages would lead to it.
!is_c() {
  print / friend struct / ? "" : $0
  next
}

# ---- C ----

# A heading begins a group.
/^\/\* ---- / {
  print_paragraph()
  title = $0
  sub(/^\/\* ---- /, "", title)
  sub(/( \(|:| ----).*/, "", title)
  name = title
  gsub(/[^a-z]/, "_", name)
  print (groups++ ? "/** @} */ " : "") "/** \\defgroup c_" name " C: " title
  print "@{ */"
  next
}

/^#ifdef __cplusplus/ && groups { # the end of extern "C"
  print "/** @} */"
  groups = 0
}

/^ *\/\* / { sub(/\/\*/, "/**") }
/[^ ].* \/\* / { sub(/ \/\* /, " /**< ") }
/^\/\*\*/ { print_paragraph() }
/^$/ {
  print_paragraph()
  print
  next
}
{ paragraph[lines++] = $0 }
/^[^ #].*[;]$|^  .*\);$/ { declarations++ }
END { print_paragraph() }
