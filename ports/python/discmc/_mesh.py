"""A mesh."""

from __future__ import annotations

import errno
import os
import tempfile
from pathlib import Path
from typing import Any, Iterator, Optional, Sequence, Union, overload

import numpy as np
from numpy.typing import NDArray

from . import _discmc, _plain_files

PathLike = Union[str, "os.PathLike[str]"]
Rings = list["NDArray[np.uint32]"]


class Polygons(Sequence[Rings]):
    """Merged polygons. Each one, polygons[i], is a list of rings, which are arrays of vertex numbers.
    The outer ring is first, counter-clockwise seen from outside; the holes follow, clockwise.
    The array polygons.normals has a unit vector for each polygon."""

    def __init__(self, data: _discmc.MeshData) -> None:
        self._ring_begin = data.ring_begin
        self._corner_begin = data.corner_begin
        self._corners = data.corners
        self.normals: NDArray[np.float64] = data.polygon_normals

    def __len__(self) -> int:
        return len(self.normals)

    def _rings(self, polygon: int) -> Rings:
        first, last = map(int, self._ring_begin[polygon : polygon + 2])
        begins = self._corner_begin[first : last + 1]
        return [self._corners[a:b] for a, b in zip(begins[:-1], begins[1:])]

    @overload
    def __getitem__(self, index: int) -> Rings: ...
    @overload
    def __getitem__(self, index: slice) -> list[Rings]: ...
    def __getitem__(self, index: Union[int, slice]) -> Union[Rings, list[Rings]]:
        chosen = range(len(self))[index]
        if isinstance(chosen, range):
            return [self._rings(each) for each in chosen]
        return self._rings(chosen)

    def __iter__(self) -> Iterator[Rings]:
        return (self._rings(each) for each in range(len(self)))


class Mesh:
    """Triangles over shared vertices, counter-clockwise seen from outside. The arrays cannot be
    written to: mesh.vertices.copy() can."""

    def __init__(self, data: _discmc.MeshData, has_polygons: bool) -> None:
        self._data = data
        self._has_polygons = has_polygons
        self._measures: Optional[_discmc.Measures] = None

    def __reduce__(self) -> tuple[Any, ...]:
        return Mesh, (self._data, self._has_polygons)

    @property
    def vertices(self) -> NDArray[np.float64]:
        """Positions, n x 3, in the unit of the spacing."""
        return self._data.vertices

    @property
    def faces(self) -> NDArray[np.uint32]:
        """Vertex numbers of triangles, m x 3."""
        return self._data.faces

    @property
    def normals(self) -> Optional[NDArray[np.float64]]:
        """A unit vector per vertex, outwards, zero where there is none; None unless asked for."""
        normals = self._data.normals
        return normals if len(normals) == len(self.vertices) else None

    @property
    def polygons(self) -> Optional[Polygons]:
        """The polygons that the triangles are parts of; None unless asked for."""
        return Polygons(self._data) if self._has_polygons else None

    @property
    def measures(self) -> _discmc.Measures:
        """All measures, which are computed once."""
        if self._measures is None:
            self._measures = self._data.measures()
        return self._measures

    def _of_closed(self, what: str) -> _discmc.Measures:
        if not self.is_closed:
            raise ValueError(
                f"the mesh is not closed, so it has no {what}; extract it with border='closed'")
        return self.measures

    @property
    def area(self) -> float:
        """The area, with the walls of cavities."""
        return self.measures.area

    @property
    def bounds(self) -> NDArray[np.float64]:
        """The least and the greatest coordinates, 2 x 3."""
        return np.array([self.measures.least, self.measures.greatest])

    @property
    def is_closed(self) -> bool:
        return self.measures.is_closed

    @property
    def volume(self) -> float:
        """The volume, without cavities."""
        return self._of_closed("volume").volume

    @property
    def bodies(self) -> int:
        """The number of pieces that are connected by edges."""
        return self._of_closed("bodies").bodies

    @property
    def cavities(self) -> int:
        return self._of_closed("cavities").cavities

    def __repr__(self) -> str:
        return f"<discmc.Mesh: {len(self.vertices)} vertices, {len(self.faces)} triangles>"

    def write(self, path: PathLike) -> None:
        """Writes a file; the extension is its format: .stl, .ply, .obj, .glb, .3mf, .vtp, and .csv or
        .json for the measures. The unit of files is the millimetre."""
        path = Path(path)
        if not _discmc.has_files:
            _plain_files.require_format(path)
        if not path.parent.is_dir():
            raise FileNotFoundError(
                errno.ENOENT, "there is no such folder; create it", str(path.parent))
        # The file appears whole, or not at all.
        handle, name = tempfile.mkstemp(dir=path.parent, prefix=path.name, suffix=".part")
        os.close(handle)
        try:
            if _discmc.has_files:
                _discmc.write_mesh(self._data, path, Path(name))
            else:
                _plain_files.write(Path(name), path.suffix, self.vertices, self.faces)
            mask = os.umask(0)
            os.umask(mask)
            os.chmod(name, 0o666 & ~mask)
            os.replace(name, path)
        except BaseException:
            os.unlink(name)
            raise

    def to_trimesh(self) -> Any:
        """The mesh as trimesh.Trimesh."""
        import trimesh

        return trimesh.Trimesh(
            self.vertices, self.faces, vertex_normals=self.normals, process=False)

    def to_pyvista(self) -> Any:
        """The mesh as pyvista.PolyData."""
        import pyvista

        corners = np.full((len(self.faces), 4), 3, dtype=np.int64)
        corners[:, 1:] = self.faces
        mesh = pyvista.PolyData(self.vertices.copy(), corners.ravel())
        if self.normals is not None:
            mesh.point_data["Normals"] = self.normals
        return mesh
