# compare.awk RECORDED MEASURED: fails when a cost has changed by more than 5 %, or a scan that is not
# fitted is told more than 15 % wrong, or a figure that was measured is not recorded.

BEGIN { FS = "\t" }
/^#/ { next }

{ figure = $1 ", " $2 ", " $3 }

FNR == NR {
  recorded[figure] = $4
  next
}

!(figure in recorded) {
  print "not recorded: " figure ": " $4
  bad++
  next
}

$1 ~ /^Costs/ {
  compared++
  if ($4 > recorded[figure] * 1.05 || $4 < recorded[figure] * 0.95) {
    print "changed: " figure ": " $4 ", recorded " recorded[figure]
    bad++
  }
}

$1 == "Errors" && $2 !~ /^fitted/ {
  compared++
  if ($4 > 15 || $4 < -15) {
    print "far off: " figure ": " $4 " %"
    bad++
  }
}

END {
  if (!compared) bad++
  print compared + 0 " figures compared, " bad + 0 " not as recorded"
  exit bad > 0
}
