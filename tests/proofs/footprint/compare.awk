# compare.awk RECORDED MEASURED: fails when a figure has risen by more than 3 %, or is in one of the
# files only.

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

{
  measured[figure] = 1
  compared++
  if ($4 > recorded[figure] * 1.03) {
    print "risen: " figure ": " $4 ", recorded " recorded[figure]
    bad++
  }
  if ($4 < recorded[figure] * 0.97) fallen++
}

END {
  for (figure in recorded)
    if (!(figure in measured)) {
      print "recorded, but not measured: " figure
      bad++
    }
  print compared + 0 " figures compared, " bad + 0 " not as recorded"
  if (fallen) print fallen " have fallen by more than 3 %: scripts/check/footprint records that"
  exit bad > 0
}
