"""The streams of a device."""

from __future__ import annotations

from typing import NamedTuple, Optional, Union

from numpy.typing import ArrayLike

from . import _discmc
from ._mesh import Mesh, Polygons
from ._options import options


class Header(NamedTuple):
    """The beginning of a stream."""

    width: int
    height: int
    depth: int
    """Planned slices; 0 if unknown."""
    spacing: tuple[float, float, float]
    """In millimetres; zeros if unknown."""
    level: int
    border: str
    channel: int
    scan: int


class Scan(NamedTuple):
    """A scan that has ended."""

    mesh: Mesh
    report: _discmc.Report
    header: Optional[Header]


class Decoder:
    """Receives the bytes of a device, scan after scan. Any bytes are safe.

    Coordinates are x, y, z in millimetres; in voxels if the stream has no spacing. channel: of the
    surface, otherwise the first that arrives. interpolate: of a stream of slices with fractions. The
    other arguments are those of extract().
    """

    def __init__(
        self,
        channel: Optional[int] = None,
        *,
        placement: Optional[ArrayLike] = None,
        interpolate: bool = False,
        relax: bool = False,
        tolerance: float = 0.05,
        triangles: int = 0,
        max_error: float = 0.0,
        normals: Optional[str] = None,
        polygons: bool = False,
    ) -> None:
        self._receiver = _discmc.Receiver(channel)
        self._has_polygons = polygons
        self._options = options(
            placement=placement, interpolate=interpolate, relax=relax, tolerance=tolerance,
            triangles=triangles, max_error=max_error, normals=normals, polygons=polygons)

    def feed(self, data: Union[bytes, bytearray, memoryview]) -> list[Scan]:
        """Accepts bytes, any number at a time. Returns the scans that end in them."""
        ended = []
        left = memoryview(data).cast("B")
        while len(left) > 0:
            left = left[self._receiver.push(left) :]
            if self._receiver.has_ended():
                ended.append(self._ended_scan())
        return ended

    def finish(self) -> Optional[Scan]:
        """No bytes follow. Returns the scan whose end is lost, if there is one."""
        if self._receiver.has_ended() or self.report.bytes == 0:
            return None
        self._receiver.finish()
        return self._ended_scan()

    def _ended_scan(self) -> Scan:
        return Scan(self.mesh(), self.report, self.header)

    def mesh(self) -> Mesh:
        """The mesh of the polygons so far; of the last scan until bytes of the next one arrive."""
        return Mesh(self._receiver.mesh(self._options), self._has_polygons)

    @property
    def polygons(self) -> Polygons:
        """The polygons so far, with the vertex numbers of mesh(). Limit: polygons=True."""
        polygons = self.mesh().polygons
        if polygons is None:
            raise ValueError("the decoder keeps no polygons; create it with polygons=True")
        return polygons

    @property
    def polygon_count(self) -> int:
        return self._receiver.polygon_count()

    @property
    def report(self) -> _discmc.Report:
        """What arrived of the scan, and what is missing."""
        return self._receiver.report()

    @property
    def header(self) -> Optional[Header]:
        """None until it has arrived."""
        fields = self._receiver.header()
        return None if fields is None else Header(**fields)
