"""Meshes of arrays."""

from __future__ import annotations

import math
import operator
from typing import Any, Iterable, Iterator, Optional, Sequence, Union

import numpy as np
from numpy.typing import ArrayLike

from . import _discmc
from ._mesh import Mesh
from ._options import Progress, array_of, matrix, number, options, triple
from ._volume import Volume


def _placed(
    volume: Any, spacing: Optional[ArrayLike], placement: Optional[ArrayLike]
) -> tuple[ArrayLike, Optional[ArrayLike]]:
    """The arguments, or the place of the volume in its file."""
    if spacing is not None and placement is not None:
        raise ValueError("the placement has the spacing in its columns; give one of the two")
    if isinstance(volume, Volume) and spacing is None and placement is None:
        placement = volume.affine
    return (1, 1, 1) if spacing is None else spacing, placement


def _of_slices(
    slices: Iterator[ArrayLike],
    low: float,
    high: float,
    spacing: ArrayLike,
    placement: Optional[ArrayLike],
    chosen: dict[str, Any],
) -> Mesh:
    # The builder's x, y and z are the columns, rows and numbers of slices.
    along = np.array(matrix(placement)) if placement is not None else np.eye(3, 4)
    if placement is None:
        along[:, :3] *= triple("spacing", spacing)
    builder = _discmc.Slices(low, high, options(placement=along[:, [2, 1, 0, 3]], **chosen))
    for each in slices:
        builder.add(np.ascontiguousarray(each))
    return Mesh(builder.finish(), chosen["polygons"])


def extract(
    volume: Union[ArrayLike, Volume, Iterable[ArrayLike]],
    level: float,
    *,
    upper: Optional[float] = None,
    spacing: Optional[Sequence[float]] = None,
    placement: Optional[ArrayLike] = None,
    border: str = "closed",
    interpolate: bool = False,
    relax: bool = False,
    tolerance: float = 0.05,
    smoothing: float = 0.0,
    triangles: int = 0,
    max_error: float = 0.0,
    normals: Optional[str] = None,
    polygons: bool = False,
    threads: int = 1,
    progress: Optional[Progress] = None,
) -> Mesh:
    """The surface of the voxels whose sample is >= level.

    volume: an array of three axes, of bool, 8- to 64-bit integers, float32 or float64, in any order
        of axes; it is not copied, and may be a numpy.memmap. Or an iterator or generator of slices,
        arrays of two axes, of which one at a time is held; axis 0 is then the number of the slice.
        Or a Volume of read(), whose place is the default of placement.
    upper: samples above it are outside, too.
    spacing: distances between voxels along axis 0, 1 and 2, in any unit. Negative if the axis runs
        backwards.
    placement: in place of the spacing, 3 x 4 numbers or an affine matrix of 4 x 4: from indices of
        the array to coordinates.
    border: 'closed', or 'open' if the surface ends at the outermost voxels.
    interpolate: moves vertices from halfway between voxels to where the samples cross the level, and
        splits triangles that are farther than tolerance (in voxels) from the crossings. Whole
        numbers cross at level - 0.5.
    relax: moves vertices to the smoothest surface that keeps every voxel on its side, and splits
        triangles as interpolate does; it uses no samples, so it suits masks.
    smoothing: of a mask, the standard deviation of a Gaussian, in the unit of the spacing. It
        implies interpolate. Each body keeps the volume of its voxels.
    triangles, max_error: decimates to this many triangles, or as far as both meshes stay within
        this distance in the unit of the spacing, whichever comes first.
    normals: 'surface' for those of the polygons, 'gradient' for those of the samples.
    polygons: fills Mesh.polygons.
    threads: 0 for one per processor.
    progress: called in the calling thread with the newest step, done and all; all is 0 if unknown.
        False cancels the call.

    Raises TypeError or ValueError with the remedy, and Cancelled.
    """
    low = number("level", level)
    high = math.inf if upper is None else number("upper", upper)
    spacing_, placement_ = _placed(volume, spacing, placement)
    chosen: dict[str, Any] = dict(
        border=border, interpolate=interpolate, relax=relax, tolerance=tolerance,
        smoothing=smoothing, triangles=triangles, max_error=max_error, normals=normals,
        polygons=polygons, threads=threads, progress=progress)
    if isinstance(volume, Iterator):
        return _of_slices(volume, low, high, spacing_, placement_, chosen)
    all_options = options(spacing=spacing_, placement=placement_, **chosen)
    return Mesh(_discmc.extract(array_of(volume), low, high, all_options), polygons)


def _bits_of(labels: Sequence[int]) -> list[int]:
    """The library has labels of 64 bits, with their sign."""
    bits = []
    for each in labels:
        try:
            label = operator.index(each)
        except TypeError:
            raise TypeError(f"only has {each!r}; give whole numbers") from None
        if not -(2**63) <= label < 2**64:
            raise ValueError(f"only has {label}; give labels from -2**63 to 2**64 - 1")
        bits.append(label - 2**64 if label >= 2**63 else label)
    return bits


def extract_labels(
    labels: Union[ArrayLike, Volume],
    only: Sequence[int] = (),
    *,
    spacing: Optional[Sequence[float]] = None,
    placement: Optional[ArrayLike] = None,
    border: str = "closed",
    smoothing: float = 0.0,
    triangles: int = 0,
    max_error: float = 0.0,
    normals: Optional[str] = None,
    polygons: bool = False,
    threads: int = 1,
    progress: Optional[Progress] = None,
) -> dict[int, Mesh]:
    """The surfaces of all labels but 0 in one pass, by label, the least first.

    Neighbours share their walls exactly. only: the labels to extract, otherwise all. The other
    arguments are those of extract(). Limit: 65,536 labels; normals 'surface'. Smoothing holds the
    array once more.
    """
    spacing_, placement_ = _placed(labels, spacing, placement)
    all_options = options(
        spacing=spacing_, placement=placement_, border=border, smoothing=smoothing,
        triangles=triangles, max_error=max_error, normals=normals, polygons=polygons,
        threads=threads, progress=progress)
    found = _discmc.extract_labels(array_of(labels), _bits_of(only), all_options)
    return {label: Mesh(data, polygons) for label, data in found.items()}
