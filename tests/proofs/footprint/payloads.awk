# The figures by which regions and slices are compared on a target. Reads the figures that exist
# already, the output of payload_work.cpp, and its counts in the same order.

BEGIN {
  OFS = "\t"
  columns = split("regions|slices, first is key|every 16th is key|every slice is key", head, "|")
}

function figure(group, name, column, value) { print group, name, column, value }

function beside(name, of_regions, of_slices, of_key_slices,    i) {
  figure("Kinds of stream", name, head[1], of_regions)
  for (i = 2; i < columns; i++) figure("Kinds of stream", name, head[i], of_slices)
  figure("Kinds of stream", name, head[columns], of_key_slices)
}

function bytes_of(name, volume,    i) {
  for (i = 1; i <= columns; i++) figure("Kinds of stream", "bytes: " name, head[i], bytes[volume, i])
}

# which: of the counts.
function per_voxel(volume, which) { return sprintf("%.1f", count[which] / of["voxels_of_" volume]) }

# first: the count of its regions.
function instructions_of(name, volume, first,    i) {
  for (i = 1; i <= columns; i++)
    figure("Kinds of stream", target ": instructions per voxel, " name, head[i],
           per_voxel(volume, first + i - 1))
}

# Slices without fractions, with two levels and with four.
function with_fractions(name, without, two, four) {
  figure("Slices with fractions", name, "slices", without)
  figure("Slices with fractions", name, "2 levels", two)
  figure("Slices with fractions", name, "4 levels", four)
}

# What a volume takes above an empty one, which has a step a row, is shared out among the steps that it has more.
function step(volume, empty, full,    steps) {
  steps = of["steps_of_" volume] - of["rows_of_" volume]
  figure("Regions and slices", "a step of slices, " volume, target,
         sprintf("%.0f", (count[full] - count[empty]) / steps))
}

function millions(name, which) {
  figure("Regions and slices", name ", millions", target, sprintf("%.1f", count[which] / 1e6))
}

FILENAME ~ /figures.txt$/ {
  split($0, part, "\t")
  if (part[1] == "Flash") target = part[3]
  if (part[1] == "Arena") arena[part[2], part[3]] = part[4]
  else taken[part[1], part[2]] = part[4]
  next
}

NF == 2 { of[$1] = $2; bytes[$1, ++told[$1]] = $2 }
NF == 1 { count[++counts] = $1 }

END {
  has_head = told["head"] == columns
  if (counts != (has_head ? 13 : 7) || told["noise"] != columns) {
    print "the counted work of payloads is not complete" > "/dev/stderr"
    exit 1
  }
  if (has_head) bytes_of("CT head (Stanford), 256x256x113, at 500", "head")
  beside("RAM for slices of 256x256",
         taken["RAM", "Extractor16"] + taken["RAM", "Encoder"] + of["arena"],
         taken["RAM", "SliceEncoder"] + arena["256x256", "slice encoder"],
         taken["RAM", "SliceEncoder"] + arena["256x256", "key slices only"])
  if (has_head) instructions_of("CT head (Stanford)", "head", 8)
  instructions_of("noise", "noise", 4)
  flash = taken["Flash", "slice encoder of 8-bit samples"]
  beside(target ": flash", taken["Flash", "sends polygons: the three above"], flash, flash)
  if (has_head) {
    with_fractions("bytes: CT head (Stanford), 256x256x113, at 500", bytes["head", 2],
      bytes["head_fractions", 1], bytes["head_fractions", 2])
    with_fractions(target ": instructions per voxel, CT head (Stanford)", per_voxel("head", 9),
      per_voxel("head", 12), per_voxel("head", 13))
  }
  flash_with = taken["Flash", "slice encoder of 8-bit samples with fractions"]
  with_fractions(target ": flash", flash, flash_with, flash_with)
  step("ball", 1, 2)
  step("noise", 3, 5)
  millions("noise as regions", 4)
  millions("noise as slices", 5)
  if (has_head) {
    millions("CT head (Stanford) as regions", 8)
    millions("CT head (Stanford) as slices", 9)
  }
}
