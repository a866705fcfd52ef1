# Instructions per voxel, active cell and link. Reads the figures that the counted work (work.cpp)
# prints, and the counts in the same order.

NF == 2 { of[$1] = $2 }
NF == 1 { count[++counts] = $1 }

END {
  if (counts != 11 || !of["cells"] || !of["links"]) {
    print "the counted work is not complete" > "/dev/stderr"
    exit 1
  }
  OFS = "\t"
  print "a voxel, empty rows of 256, 8 bits", sprintf("%.2f", count[1] / of["wide_voxels"])
  print "a voxel, empty rows of 256, 16 bits", sprintf("%.2f", count[2] / of["wide_voxels"])
  print "an active cell: extraction", sprintf("%.0f", (count[4] - count[3]) / of["cells"])
  print "a link of a ring: encoding", sprintf("%.1f", (count[5] - count[4]) / of["links"])
  print "a voxel, empty rows of 256, 8 bits, as slices", sprintf("%.2f", count[6] / of["wide_voxels"])
  print "the ball as regions, thousands", sprintf("%.0f", count[5] / 1000)
  print "the ball as slices, thousands", sprintf("%.0f", count[7] / 1000)
  split("midpoint centroid", kind, " ")
  for (i = 1; i <= 2; i++) {
    print "a normal of a " kind[i] ", octahedral", sprintf("%.0f", count[7 + i] / of["normals"])
    print "a normal of a " kind[i] ", Q1.14", sprintf("%.0f", count[9 + i] / of["normals"])
  }
}
