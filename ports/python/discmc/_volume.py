"""Volumes of files."""

from __future__ import annotations

import os
import warnings
from dataclasses import dataclass
from pathlib import Path
from typing import Any, Optional, Sequence, Union

import numpy as np
from numpy.typing import NDArray

from . import _discmc
from ._options import triple


class VolumeWarning(UserWarning):
    """What read() assumed, or left out of the file."""


@dataclass(frozen=True)
class Volume:
    """An array of values with its place. numpy.asarray(volume) is the array."""

    array: NDArray[Any]
    """Values by x, y, z. The samples of a row along x are adjacent in memory."""
    spacing: tuple[float, float, float]
    """Distances between voxels along x, y, z in millimetres. Negative if the axis runs backwards."""
    affine: NDArray[np.float64]
    """4 x 4: from indices of the array to coordinates in millimetres."""
    space: str
    """'lps' or 'ras' for the coordinates of a patient, else 'scanner'."""
    units: str
    """The unit of lengths: 'mm'."""
    format: str
    notes: tuple[str, ...]

    def __array__(self, dtype: Any = None, copy: Optional[bool] = None) -> NDArray[Any]:
        if copy:
            return np.array(self.array, dtype=dtype)
        return np.asarray(self.array, dtype=dtype)

    def __repr__(self) -> str:
        voxels = " x ".join(map(str, self.array.shape))
        return f"<discmc.Volume: {voxels} voxels, {self.array.dtype}, spacing {self.spacing} mm, {self.format}>"


def read(
    path: Union[str, "os.PathLike[str]"],
    *,
    spacing: Optional[Sequence[float]] = None,
    series: str = "",
    frame: Optional[int] = None,
    channel: Optional[int] = None,
    level: Optional[int] = None,
) -> Volume:
    """Reads a volume in any format of the command: a file, or a folder of DICOM or pictures.

    What the reader assumes, or leaves out, is a VolumeWarning, and in Volume.notes. Samples with a
    scale in the file become values of float32, or float64 if they have more than 16 bits.
    spacing: in place of that in the file. series: of DICOM. frame, channel, level: which volume,
    channel or resolution of a file with several, counted from 0.
    """
    if not _discmc.has_files:
        raise RuntimeError(
            "this build of discmc reads no files; build it with zlib, libpng and libarchive")
    options = _discmc.VolumeOptions()
    if spacing is not None:
        options.spacing = triple("spacing", spacing)
    options.series = series
    options.frame = frame
    options.channel = channel
    options.level = level
    found = _discmc.read_volume(Path(path), options)
    for note in found["notes"]:
        warnings.warn(f"{path}: {note}", VolumeWarning, stacklevel=2)
    array: NDArray[Any] = found["array"].T
    if (found["slope"], found["intercept"]) != (1, 0):
        is_wide = array.dtype.itemsize > 2 and array.dtype != np.float32
        array = array.astype(np.float64 if is_wide else np.float32)
        array *= found["slope"]
        array += found["intercept"]
    affine = np.eye(4)
    affine[:3, :3] = np.array(found["axes"]).T
    affine[:3, 3] = found["origin"]
    return Volume(
        array, triple("spacing", found["spacing"]), affine, found["space"], "mm", found["format"],
        tuple(found["notes"]))
