"""Meshes of volumes: closed, merged triangles of numpy arrays, and of the streams of scanners.

    mesh = discmc.extract(volume, 300, spacing=(2, 1, 1))
    mesh.vertices, mesh.faces      # column 0 of vertices belongs to axis 0 of the volume
    mesh.write("surface.stl")

marching_cubes() has the arguments and results of scikit-image's function of this name.
"""

from ._decoder import Decoder, Header, Scan
from ._discmc import Cancelled, Measures, Report
from ._discmc import version as __version__
from ._extract import extract, extract_labels
from ._extractor import Extractor, Outline, Statistics
from ._marching_cubes import marching_cubes
from ._mesh import Mesh, Polygons
from ._volume import Volume, VolumeWarning, read

__all__ = [
    "Cancelled",
    "Decoder",
    "Extractor",
    "Header",
    "Measures",
    "Mesh",
    "Outline",
    "Polygons",
    "Report",
    "Scan",
    "Statistics",
    "Volume",
    "VolumeWarning",
    "__version__",
    "extract",
    "extract_labels",
    "marching_cubes",
    "read",
]
