"""The compared figures of a mesh: its triangles, whether they are closed, and the enclosed volume."""
import numpy


def figures(points, triangles):
    """points: n x 3. triangles: n x 3 numbers of points. Points at the same position are one point."""
    points = numpy.ascontiguousarray(points, dtype=numpy.float64).reshape(-1, 3)
    triangles = numpy.asarray(triangles, dtype=numpy.int64).reshape(-1, 3)
    places = (points + 0.0).view([("", points.dtype)] * 3).ravel()  # -0 is 0
    corners = numpy.unique(places, return_inverse=True)[1].reshape(-1)[triangles]
    begin, end = corners.ravel(), numpy.roll(corners, -1, axis=1).ravel()
    forth = numpy.sort(begin * len(points) + end)
    back = numpy.sort(end * len(points) + begin)
    a, b, c = (points[triangles[:, i]] for i in range(3))
    return {
        "triangles": len(triangles),
        "closed": bool(numpy.array_equal(forth, back)),
        "volume": float(numpy.einsum("ij,ij->i", a, numpy.cross(b, c)).sum() / 6),
    }


def figures_of_stl(file):
    """Of a binary STL file."""
    record = [("normal", "<f4", 3), ("corners", "<f4", (3, 3)), ("attribute", "<u2")]
    triangles = numpy.fromfile(file, dtype=record, offset=84)
    points = triangles["corners"].reshape(-1, 3)
    return figures(points, numpy.arange(len(points)))


def figures_of_off(file):
    """Of an OFF file of triangles, which is text."""
    with open(file) as text:
        words = text.read().split()
    assert words[0] == "OFF"
    vertices, faces = int(words[1]), int(words[2])
    words = numpy.array(words[4:], dtype=numpy.float64)
    points, rows = words[:3 * vertices].reshape(-1, 3), words[3 * vertices:].reshape(faces, -1)
    assert (rows[:, 0] == 3).all(), "faces of more than three corners"
    return figures(points, rows[:, 1:4])
