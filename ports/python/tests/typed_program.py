"""What type checkers see of the package: a test runs mypy over it."""

from typing import Optional

import numpy as np
from numpy.typing import NDArray

import discmc


def vertices_of(volume: NDArray[np.int16]) -> NDArray[np.float64]:
    mesh: discmc.Mesh = discmc.extract(volume, 300, spacing=(1, 1, 2), normals="surface")
    normals: Optional[NDArray[np.float64]] = mesh.normals
    size: float = mesh.volume + mesh.area + mesh.bodies
    print(normals, size)
    return mesh.vertices


def receive(data: bytes) -> list[discmc.Mesh]:
    decoder = discmc.Decoder()
    lost: int = decoder.report.lost_packets
    print(lost)
    return [scan.mesh for scan in decoder.feed(data)]


def labels_of(labels: NDArray[np.uint16]) -> dict[int, discmc.Mesh]:
    return discmc.extract_labels(labels)
