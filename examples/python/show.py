"""Shows the surface of a volume with matplotlib.

usage: show.py FILE LEVEL [PICTURE]; FILE is an array of NumPy, or any volume that discmc reads.
"""

import sys

import matplotlib
import numpy as np

import discmc


def main(file, level, picture=None):
    if picture:
        matplotlib.use("Agg")
    from matplotlib import pyplot
    from mpl_toolkits.mplot3d.art3d import Poly3DCollection

    volume = np.load(file, mmap_mode="r") if file.endswith(".npy") else discmc.read(file)
    mesh = discmc.extract(volume, float(level), interpolate=True)
    corners = mesh.vertices[mesh.faces]
    normals = np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0])
    light = np.abs(normals @ (0.3, -0.5, 0.8)) / np.linalg.norm(normals, axis=1)
    axes = pyplot.figure().add_subplot(projection="3d")
    axes.add_collection3d(Poly3DCollection(corners, facecolors=pyplot.cm.bone(0.3 + 0.6 * light)))
    least, greatest = mesh.bounds
    axes.set(xlim=(least[0], greatest[0]), ylim=(least[1], greatest[1]), zlim=(least[2], greatest[2]))
    axes.set_box_aspect(greatest - least)
    axes.set_title(f"{len(mesh.faces)} triangles, volume {mesh.volume:.6g}")
    if picture:
        pyplot.savefig(picture)
    else:
        pyplot.show()


if __name__ == "__main__":
    if len(sys.argv) not in (3, 4):
        sys.exit(__doc__)
    main(*sys.argv[1:])
