"""Arguments of several functions."""

from __future__ import annotations

import operator
import os
from typing import Any, Callable, Optional

import numpy as np
from numpy.typing import ArrayLike, NDArray

from . import _discmc

Progress = Callable[[str, int, int], Any]

_borders = {"closed": _discmc.Border.closed, "open": _discmc.Border.open}
_normals = {
    None: _discmc.Normals.none,
    "surface": _discmc.Normals.surface,
    "gradient": _discmc.Normals.gradient,
}


def choice(name: str, value: Any, choices: dict[Any, Any]) -> Any:
    if value not in choices:
        listed = " or ".join(repr(each) for each in choices)
        raise ValueError(f"{name} is {value!r}; expected {listed}")
    return choices[value]


def number(name: str, value: Any) -> float:
    try:
        if not isinstance(value, (str, bytes)):  # float("1") is a number
            return float(value)
    except (TypeError, ValueError):
        pass
    raise TypeError(f"{name} is {value!r}; give a number")


def count(name: str, value: Any, most: int) -> int:
    try:
        whole = operator.index(value)
    except TypeError:
        raise TypeError(f"{name} is {value!r}; give a whole number") from None
    if whole < 0:
        raise ValueError(f"{name} is {whole}; give 0 or more")
    if whole > most:
        raise ValueError(f"{name} is {whole}; give at most {most}")
    return whole


def array_of(volume: Any) -> NDArray[Any]:
    if isinstance(volume, (str, os.PathLike)):
        raise TypeError(f"the volume is the path {str(volume)!r}; give an array, as discmc.read(path)")
    if isinstance(volume, np.ma.MaskedArray) and np.any(volume.mask):
        raise TypeError(
            "masks of arrays are not supported; give array.filled(value), with a value outside the "
            "surface")
    return np.asarray(volume)


def triple(name: str, value: ArrayLike) -> tuple[float, float, float]:
    numbers = np.asarray(value, dtype=float)
    if numbers.shape != (3,):
        raise ValueError(f"{name} has the shape {numbers.shape}; give three numbers")
    return (float(numbers[0]), float(numbers[1]), float(numbers[2]))


def matrix(placement: ArrayLike) -> list[list[float]]:
    """Three rows of four numbers. The fourth row of an affine matrix is dropped."""
    rows = np.asarray(placement, dtype=float)
    if rows.shape == (4, 4) and np.array_equal(rows[3], (0, 0, 0, 1)):
        rows = rows[:3]
    if rows.shape != (3, 4):
        raise ValueError(
            f"placement has the shape {rows.shape}; give 3 x 4 numbers, or an affine matrix of 4 x 4")
    return [[float(number) for number in row] for row in rows]


def options(
    *,
    spacing: ArrayLike = (1.0, 1.0, 1.0),
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
) -> _discmc.Options:
    chosen = _discmc.Options()
    chosen.spacing = triple("spacing", spacing)
    if placement is not None:
        chosen.placement = matrix(placement)
    chosen.border = choice("border", border, _borders)
    chosen.interpolates = interpolate
    chosen.relaxes = relax
    chosen.tolerance = number("tolerance", tolerance)
    chosen.smoothing = number("smoothing", smoothing)
    chosen.triangles = count("triangles", triangles, 2**64 - 1)
    chosen.max_error = number("max_error", max_error)
    chosen.normals = choice("normals", normals, _normals)
    chosen.polygons = polygons
    chosen.threads = count("threads", threads, 2**32 - 1)
    chosen.progress = progress
    return chosen
