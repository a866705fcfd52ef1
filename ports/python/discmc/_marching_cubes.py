"""marching_cubes() of scikit-image."""

from __future__ import annotations

from typing import Any, Optional, Sequence

import numpy as np
from numpy.typing import ArrayLike, NDArray

from . import _discmc
from ._options import array_of, number, options, triple

Arrays = tuple["NDArray[np.floating[Any]]", "NDArray[np.int32]", "NDArray[np.float32]", "NDArray[np.float32]"]


def _supported(samples: NDArray[Any]) -> NDArray[Any]:
    dtype = samples.dtype.newbyteorder("=")
    return samples.astype("float32" if dtype == "float16" else dtype, copy=False)


def marching_cubes(
    volume: ArrayLike,
    level: Optional[float] = None,
    *,
    spacing: Sequence[float] = (1.0, 1.0, 1.0),
    gradient_direction: str = "descent",
    step_size: int = 1,
    allow_degenerate: bool = True,
    method: str = "lewiner",
    mask: Optional[ArrayLike] = None,
    tolerance: float = 0.05,
) -> Arrays:
    """The interpolated surface with the arguments and results of skimage.measure.marching_cubes().

    Returns verts, faces, normals and values. The surface is open where the volume ends, as in
    scikit-image. Flat parts have fewer and larger triangles. Each crossing of the level is at most
    `tolerance` voxels from the mesh, and on it with a tolerance of 0.

    Other than in scikit-image, a sample equal to the level is inside, no axis needs two samples, and
    samples keep their precision. Half precision and another byte order are copied. Errors:
    ValueError for a mask, and for a method but 'lewiner'.
    """
    if mask is not None:
        raise ValueError(
            "mask is not supported; copy the volume and set samples outside the mask below the level")
    if method != "lewiner":
        raise ValueError(f"method is {method!r}; only the default 'lewiner' is supported")
    if gradient_direction not in ("descent", "ascent"):
        raise ValueError(f"gradient_direction is {gradient_direction!r}; expected 'descent' or 'ascent'")
    if step_size < 1 or step_size != int(step_size):
        raise ValueError(f"step_size is {step_size}; give a whole number from 1 on")
    samples = array_of(volume)
    if samples.ndim != 3:
        raise ValueError(f"the volume has {samples.ndim} axes; it needs 3")
    least, greatest = samples.min(), samples.max()
    if level is None:
        level = 0.5 * (float(least) + float(greatest))
    level = number("level", level)
    if not least <= level <= greatest:
        raise ValueError(
            f"the level is {level}; give one within the values of the volume, {least} to {greatest}")
    distances = np.array(triple("spacing", spacing)) * step_size
    samples = _supported(samples[::step_size, ::step_size, ::step_size])
    data = _discmc.extract(
        samples, level, np.inf,
        options(spacing=distances, border="open", interpolate=True, tolerance=tolerance,
                normals="gradient"))
    if len(data.faces) == 0:
        raise RuntimeError(f"there is no surface at the level {level}")
    values = _discmc.ranges_around(samples, data, distances)
    faces = data.faces.astype(np.int32)
    if not allow_degenerate:
        corners = data.vertices[faces]
        sides = np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0])
        faces = faces[np.any(sides != 0, axis=1)]
    if gradient_direction == "descent":  # left-handed, as in scikit-image
        faces = np.ascontiguousarray(faces[:, ::-1])
    # scikit-image has double precision if it multiplies by a spacing.
    is_unit = np.array_equal(spacing, (1, 1, 1))
    vertices: NDArray[np.floating[Any]] = data.vertices
    vertices = vertices.astype(np.float32) if is_unit else vertices.copy()
    return vertices, faces, data.normals.astype(np.float32), values
