"""Files of meshes where the writers of the command were not built."""

from __future__ import annotations

from pathlib import Path

import numpy as np
from numpy.typing import NDArray


def require_format(path: Path) -> None:
    if path.suffix.lower() not in (".stl", ".ply"):
        raise ValueError(
            f"{path}: this build of discmc writes .stl and .ply; for other formats build it with "
            "zlib, libpng and libarchive")


def write(file: Path, extension: str, vertices: NDArray[np.float64], faces: NDArray[np.uint32]) -> None:
    with open(file, "wb") as out:
        if extension.lower() == ".stl":
            triangles = np.zeros(len(faces), [("normal", "<f4", 3), ("corners", "<f4", (3, 3)), ("", "<u2")])
            corners = vertices[faces]
            normals = np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0])
            lengths = np.linalg.norm(normals, axis=1, keepdims=True)
            triangles["normal"] = np.divide(normals, lengths, out=normals, where=lengths > 0)
            triangles["corners"] = corners
            out.write(b"binary STL by discmc".ljust(80) + len(faces).to_bytes(4, "little"))
            out.write(triangles.tobytes())
        else:
            triangles = np.zeros(len(faces), [("count", "u1"), ("corners", "<u4", 3)])
            triangles["count"] = 3
            triangles["corners"] = faces
            out.write(
                (
                    "ply\nformat binary_little_endian 1.0\n"
                    f"element vertex {len(vertices)}\n"
                    "property double x\nproperty double y\nproperty double z\n"
                    f"element face {len(faces)}\nproperty list uchar uint vertex_indices\nend_header\n"
                ).encode())
            out.write(vertices.astype("<f8").tobytes())
            out.write(triangles.tobytes())
