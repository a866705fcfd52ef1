# The figures by which regions and slices are compared on a target. Reads, in this order:
#   figures.txt              the figures that exist already
#   payload_work.txt         the output of payload_work.cpp
#   payload_work_counts.txt  its counts
#   volumes.txt              a line for each volume, CT head (Stanford) first: its name, the bytes of six streams, the
#                            voxels, and the counts of the six, with tabs between them

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

# counts: those of the streams begin behind `first`.
function instructions_of(name, voxels, counts, first,    i) {
  for (i = 1; i <= columns; i++)
    figure("Kinds of stream", target ": instructions per voxel, " name, head[i],
           sprintf("%.1f", counts[first + i] / voxels))
}

# Slices without fractions, with two levels and with four.
function with_fractions(name, slices, two, four) {
  figure("Slices with fractions", name, "slices", slices)
  figure("Slices with fractions", name, "2 levels", two)
  figure("Slices with fractions", name, "4 levels", four)
}

# i: a stream of a volume in volumes.txt.
function per_voxel(line, i,    part) {
  split(line, part, "\t")
  return sprintf("%.1f", part[8 + i] / part[8])
}

function streams_of(line,    name) {
  name = substr(line, 1, index(line, "\t") - 1)
  figure("Streams of volumes", name, "polygons", per_voxel(line, 1))
  figure("Streams of volumes", name, "slices", per_voxel(line, 2))
  figure("Streams of volumes", name, "2 levels", per_voxel(line, 5))
  figure("Streams of volumes", name, "4 levels", per_voxel(line, 6))
}

# What a volume takes above an empty one, which has a step a row, is shared out among the steps that it has more.
function step(volume, empty, full,    steps) {
  steps = of["steps_of_" volume] - of["rows_of_" volume]
  figure("Regions and slices", "a step of slices, " volume, target,
         sprintf("%.0f", (count[full] - count[empty]) / steps))
}

function millions(name, instructions) {
  figure("Regions and slices", name ", millions", target, sprintf("%.1f", instructions / 1e6))
}

FILENAME ~ /figures.txt$/ {
  split($0, part, "\t")
  if (part[1] == "Flash") target = part[3]
  if (part[1] == "Arena") arena[part[2], part[3]] = part[4]
  else taken[part[1], part[2]] = part[4]
  next
}

FILENAME ~ /volumes.txt$/ { volume[++volumes] = $0; next }

NF == 2 { of[$1] = $2; told[$1]++ }
NF == 1 { count[++counts] = $1 }

END {
  if (counts != 7 || told["noise"] != columns) {
    print "the counted work of payloads is not complete" > "/dev/stderr"
    exit 1
  }
  split(volume[1], stanford, "\t")
  if (volumes)
    for (i = 1; i <= columns; i++)
      figure("Kinds of stream", "bytes: CT head (Stanford), 256x256x113, at 500", head[i], stanford[1 + i])
  beside("RAM for slices of 256x256",
         taken["RAM", "Extractor16"] + taken["RAM", "Encoder"] + of["arena"],
         taken["RAM", "SliceEncoder"] + arena["256x256", "slice encoder"],
         taken["RAM", "SliceEncoder"] + arena["256x256", "key slices only"])
  if (volumes) instructions_of("CT head (Stanford)", stanford[8], stanford, 8)
  instructions_of("noise", of["voxels_of_noise"], count, 3)
  polygons = taken["Flash", "sends polygons: the three above"]
  slices = taken["Flash", "slice encoder of 8-bit samples"]
  beside(target ": flash", polygons, slices, slices)
  if (volumes) {
    with_fractions("bytes: CT head (Stanford), 256x256x113, at 500", stanford[3], stanford[6], stanford[7])
    with_fractions(target ": instructions per voxel, CT head (Stanford)", per_voxel(volume[1], 2),
      per_voxel(volume[1], 5), per_voxel(volume[1], 6))
  }
  fractions = taken["Flash", "slice encoder of 8-bit samples with fractions"]
  with_fractions(target ": flash", slices, fractions, fractions)
  if (volumes > 1) for (i = 1; i <= volumes; i++) streams_of(volume[i])
  step("ball", 1, 2)
  step("noise", 3, 5)
  millions("noise as regions", count[4])
  millions("noise as slices", count[5])
  if (volumes) {
    millions("CT head (Stanford) as regions", stanford[9])
    millions("CT head (Stanford) as slices", stanford[10])
  }
}
