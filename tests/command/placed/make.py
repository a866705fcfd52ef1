#!/usr/bin/python3
"""Makes sform.nii and qform.nii, each with one voxel that is on, and prints where NiBabel has the
six ends of its half axes: the vertices of its surface, in RAS. They stand in ../placing_test.cpp.
Debian: python3-nibabel."""

import nibabel
import numpy

MARKED = (4, 1, 2)


def turned(degrees, axis):
    c, s = numpy.cos(numpy.radians(degrees)), numpy.sin(numpy.radians(degrees))
    i, j = [k for k in range(3) if k != axis]
    matrix = numpy.eye(3)
    matrix[i, i], matrix[i, j], matrix[j, i], matrix[j, j] = c, -s, s, c
    return matrix


def write(name, linear, origin, set_form):
    affine = numpy.eye(4)
    affine[:3, :3], affine[:3, 3] = linear, origin
    samples = numpy.zeros((6, 5, 4), numpy.int16)
    samples[MARKED] = 1000
    image = nibabel.Nifti1Image(samples, None)
    set_form(image, affine)
    image.header.set_xyzt_units("mm")
    nibabel.save(image, name)

    affine = nibabel.load(name).affine
    print(name, "determinant %.6f" % numpy.linalg.det(affine[:3, :3]))
    for axis in range(3):
        for half in (-0.5, 0.5):
            voxel = numpy.array(MARKED, float)
            voxel[axis] += half
            print("{%.6f, %.6f, %.6f}," % tuple(nibabel.affines.apply_affine(affine, voxel)))


rotation = turned(20, 0) @ turned(-35, 1) @ turned(50, 2)
# Like a scanner with a tilted gantry, with the usual left-handed order of voxels.
sheared = rotation @ numpy.diag([-0.7, 0.8, 2.5]) @ [[1, 0, 0], [0, 1, 0.3], [0, 0, 1]]
write("sform.nii", sheared, [91.5, -126.25, -72.75],
      lambda image, affine: (image.set_qform(None, code=0), image.set_sform(affine, code=1)))
write("qform.nii", rotation @ numpy.diag([0.5, 0.5, -3]), [-30.5, 12.125, 700.25],
      lambda image, affine: (image.set_sform(None, code=0), image.set_qform(affine, code=1)))
