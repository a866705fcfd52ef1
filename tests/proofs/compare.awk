# compare.awk RECORDED MEASURED: fails when a figure has risen too far, or was measured and is not
# recorded.
#   -v most=PERCENT  how far it may rise
#   -v groups=REGEX  compares only figures of these groups
#   -v both=1        fails when a figure has fallen by more, too
#   -v all=1         fails when a figure is recorded and was not measured

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

$1 ~ groups {
  measured[figure] = 1
  compared++
  change = $4 > recorded[figure] * (1 + most / 100) ? "risen" : $4 < recorded[figure] * (1 - most / 100) ? "fallen" : ""
  if (change == "risen" || change && both) {
    print change ": " figure ": " $4 ", recorded " recorded[figure]
    bad++
  } else if (change) {
    fallen++
  }
}

END {
  for (figure in recorded)
    if (all && !(figure in measured)) {
      print "recorded, but not measured: " figure
      bad++
    }
  if (!compared) bad++
  print compared + 0 " figures compared, " bad + 0 " not as recorded"
  if (fallen) print fallen " have fallen by more than " most " %: record that"
  exit bad > 0
}
