"""The extractor of firmware."""

from __future__ import annotations

from typing import NamedTuple, Sequence

import numpy as np
from numpy.typing import ArrayLike, NDArray

from . import _discmc
from ._options import choice, triple


class Outline(NamedTuple):
    """A merged polygon of a scan. Coordinates are x, y, z: column, row and slice, in voxels."""

    normal: tuple[int, int, int]
    """Outwards, not of unit length."""
    rings: list[NDArray[np.float64]]
    """The corners of the outer ring, counter-clockwise seen from outside, then of holes."""


class Statistics(NamedTuple):
    """The totals of a scan so far."""

    cells: int
    facets: int
    classic_triangles: int
    regions: int
    rings: int
    links: int
    fragments: int
    """Pieces of polygons that left early for lack of memory. Their polygons are in no outline; a
    Decoder of the stream joins them."""
    skipped_rows: int
    slots: int
    """The slots that the memory has room for."""
    peak_slots: int
    peak_holes: int


class Extractor:
    """The extractor of the firmware library, in the memory that a device would give it.

    Samples go in while the scan runs; polygons come out. For trying the settings of a device: on a
    PC, extract() is faster and needs no bound.

    width, height: samples of a row, rows of a slice. level: a whole number; a voxel is inside if its
    sample is >= the level. memory: the arena, in bytes, at least minimum_memory(). index_bits: 16 as
    in most firmware, or 32. encode: also makes the stream of the device, for encoded(). spacing: of
    the stream, along x, y and z in millimetres. scan, channel: numbers in the stream.
    """

    def __init__(
        self,
        width: int,
        height: int,
        level: int,
        *,
        memory: int,
        border: str = "closed",
        index_bits: int = 16,
        encode: bool = False,
        spacing: Sequence[float] = (0.0, 0.0, 0.0),
        scan: int = 0,
        channel: int = 0,
    ) -> None:
        is_open = choice("border", border, {"closed": False, "open": True})
        distances = triple("spacing", spacing)
        if max(abs(distance) for distance in distances) > 2147:
            raise ValueError(f"spacing is {distances}; give at most 2147 mm, as a stream holds it")
        self._encodes = encode
        self._size = (height, width)
        self._scan = _discmc.start(
            width, height, level, memory, is_open, choice("index_bits", index_bits, {16: 16, 32: 32}),
            encode, distances, scan, channel)

    @staticmethod
    def minimum_memory(width: int, height: int, index_bits: int = 16) -> int:
        """The least memory for slices of this size, in bytes."""
        return _discmc.minimum_bytes(width, height, choice("index_bits", index_bits, {16: 16, 32: 32}))

    def push(self, samples: ArrayLike) -> None:
        """Accepts samples of uint8, uint16 or int16: a part of a row, a row, an image, a volume."""
        array = np.ascontiguousarray(samples)
        inner = array.shape[1:] if array.ndim == 2 else array.shape[-2:]
        if array.ndim > 1 and inner != self._size[-len(inner):]:
            raise ValueError(
                f"the samples have the shape {array.shape}; a slice has {self._size[0]} rows of "
                f"{self._size[1]}, the last axis along x")
        self._scan.push(array)

    def skip_row(self, repeat: bool = False) -> None:
        """Replaces a missing row by voxels outside, or by the row before."""
        self._scan.skip_row(repeat)

    def finish(self) -> None:
        """Ends the scan after a whole slice."""
        self._scan.finish()

    def abandon(self) -> None:
        """Ends the scan anywhere."""
        self._scan.abandon()

    def polygons(self) -> list[Outline]:
        """The polygons that were completed since the last call."""
        return [Outline(normal, rings) for normal, rings in self._scan.polygons()]

    def encoded(self) -> bytes:
        """The bytes of the stream since the last call."""
        if not self._encodes:
            raise ValueError("the extractor makes no stream; create it with encode=True")
        return self._scan.encoded()

    @property
    def statistics(self) -> Statistics:
        return Statistics(**self._scan.statistics())

    @property
    def bytes_used(self) -> int:
        """The bytes of the memory that the scan has used so far."""
        return self._scan.bytes_used()

    @property
    def slices(self) -> int:
        """The number of complete slices."""
        return self._scan.place()[0]

    @property
    def rows(self) -> int:
        """The number of complete rows of the next slice."""
        return self._scan.place()[1]
