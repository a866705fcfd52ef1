import multiprocessing
import threading
import weakref
from concurrent.futures import ProcessPoolExecutor
from copy import deepcopy

import numpy as np
import pytest
from conftest import ball_of, euler_characteristic, is_closed, signed_volume

import discmc

DTYPES = "bool u1 i1 u2 i2 u4 i4 u8 i8 f4 f8".split()


def points(mesh):
    return {tuple(vertex) for vertex in mesh.vertices}


def of(dtype, ball):
    return ball >= 100 if dtype == "bool" else ball.clip(0, 127).astype(dtype)


def test_a_ball_has_its_measures(ball):
    mesh = discmc.extract(ball, 100, interpolate=True)
    assert mesh.vertices.dtype == np.float64 and mesh.faces.dtype == np.uint32
    assert mesh.is_closed and mesh.bodies == 1 and mesh.cavities == 0
    assert mesh.volume == pytest.approx(4 / 3 * np.pi * 8.2**3, rel=0.02)
    assert mesh.volume == pytest.approx(signed_volume(mesh.vertices, mesh.faces))
    assert mesh.area == pytest.approx(4 * np.pi * 8.2**2, rel=0.02)
    assert euler_characteristic(mesh.faces) == 2
    assert mesh.bounds == pytest.approx(np.array([[2.8, 4.3, 4.8], [19.2, 20.7, 21.2]]), abs=0.1)


@pytest.mark.parametrize("dtype", DTYPES)
def test_every_dtype_gives_the_same_mesh(ball, dtype):
    level = 1 if dtype == "bool" else 100
    expected = discmc.extract(ball.astype(np.int32), 100)
    mesh = discmc.extract(of(dtype, ball), level)
    assert points(mesh) == points(expected)
    assert np.array_equal(mesh.faces, expected.faces)


@pytest.mark.parametrize("dtype", DTYPES)
@pytest.mark.parametrize("axes", [(0, 1, 2), (2, 1, 0), (1, 0, 2), (1, 2, 0)])
@pytest.mark.parametrize("step", [1, 2, -1, -2])
def test_any_strides_are_read_in_place(ball, dtype, axes, step):
    level = 1 if dtype == "bool" else 100
    view = of(dtype, ball).transpose(axes)[::step, ::2, ::-1]
    copy = np.ascontiguousarray(view)
    mesh, expected = discmc.extract(view, level), discmc.extract(copy, level)
    assert points(mesh) == points(expected)
    assert mesh.volume == pytest.approx(expected.volume)
    assert mesh.area == pytest.approx(expected.area)
    assert signed_volume(mesh.vertices, mesh.faces) > 0


def test_column_0_belongs_to_axis_0():
    volume = np.zeros((5, 6, 7), np.uint8)
    volume[1:4, 2:4, 5] = 1
    mesh = discmc.extract(volume, 1, spacing=(1, 10, 100))
    assert mesh.bounds.tolist() == [[0.5, 15, 450], [3.5, 35, 550]]


def test_a_placement_maps_indices_to_coordinates(ball):
    matrix = np.array([[0, 0, 2, 10], [3, 0, 0, 20], [0, -1, 0, 30], [0, 0, 0, 1]])
    indices = discmc.extract(ball, 100)
    placed = discmc.extract(ball, 100, placement=matrix)
    assert {tuple(matrix[:3] @ (*point, 1)) for point in points(indices)} == points(placed)
    assert placed.volume == pytest.approx(6 * indices.volume)
    assert signed_volume(placed.vertices, placed.faces) > 0


def test_upper_makes_a_shell(ball):
    mesh = discmc.extract(ball, 100, upper=140)
    assert (mesh.bodies, mesh.cavities) == (1, 1)


def test_an_open_border_leaves_the_surface_open():
    volume = ball_of(centre=(0, 12, 13))
    assert discmc.extract(volume, 100).is_closed
    mesh = discmc.extract(volume, 100, border="open")
    assert not mesh.is_closed
    with pytest.raises(ValueError, match="no volume.*border='closed'"):
        mesh.volume


def test_polygons_cover_the_triangles(ball):
    mesh = discmc.extract(ball, 100, polygons=True)
    assert discmc.extract(ball, 100).polygons is None
    area = 0
    for rings, normal in zip(mesh.polygons, mesh.polygons.normals):
        for ring in rings:
            corners = mesh.vertices[ring]
            area += np.cross(corners, np.roll(corners, -1, 0)).sum(0) @ normal / 2
    assert area == pytest.approx(mesh.area)
    assert len(mesh.polygons[0]) == 1 and mesh.polygons[-1][0].dtype == np.uint32
    with pytest.raises(IndexError):
        mesh.polygons[len(mesh.polygons)]


@pytest.mark.parametrize("normals", ["surface", "gradient"])
def test_normals_point_outwards(ball, normals):
    mesh = discmc.extract(ball, 100, interpolate=True, normals=normals)
    outwards = mesh.vertices - (11, 12.5, 13)
    outwards /= np.linalg.norm(outwards, axis=1, keepdims=True)
    assert (np.einsum("ij,ij->i", mesh.normals, outwards) > 0.9).all()
    assert discmc.extract(ball, 100).normals is None


def test_threads_do_not_change_the_mesh(ball):
    mesh = discmc.extract(np.tile(ball, (4, 4, 4)), 100)
    others = discmc.extract(np.tile(ball, (4, 4, 4)), 100, threads=3)
    assert points(mesh) == points(others)
    assert mesh.volume == pytest.approx(others.volume)


def test_decimated_and_smoothed_meshes_stay_closed(ball):
    mask = ball >= 100
    smooth = discmc.extract(mask, 1, smoothing=1)
    assert smooth.area == pytest.approx(4 * np.pi * 8.2**2, rel=0.03)
    mesh = discmc.extract(mask, 1, smoothing=1, triangles=300)
    assert len(mesh.faces) in (299, 300) and mesh.is_closed
    assert mesh.volume == pytest.approx(smooth.volume, rel=1e-5)
    mesh = discmc.extract(mask, 1, smoothing=1, max_error=0.2)
    assert len(mesh.faces) < 0.6 * len(smooth.faces) and mesh.is_closed


def test_a_memory_map_is_read_in_place(ball, tmp_path):
    np.save(tmp_path / "ball.npy", ball)
    volume = np.load(tmp_path / "ball.npy", mmap_mode="r")
    assert points(discmc.extract(volume, 100)) == points(discmc.extract(ball, 100))


@pytest.mark.parametrize(
    "options",
    [{}, {"spacing": (3, 2, -1)}, {"interpolate": True}, {"polygons": True, "normals": "surface"},
     {"placement": [[0, 2, 0, 5], [1, 0, 0, 6], [0, 0, 3, 7]]}])
def test_slices_give_the_mesh_of_the_volume(ball, options):
    mesh = discmc.extract((each for each in ball), 100, **options)
    expected = discmc.extract(ball, 100, **options)
    assert np.allclose(sorted(points(mesh)), sorted(points(expected)))
    assert mesh.volume == pytest.approx(expected.volume)
    assert mesh.is_closed


def test_one_slice_at_a_time_is_held(ball):
    slices = []

    def scan():
        for each in ball:
            image = each.copy()
            slices.append(weakref.ref(image))
            yield image
            del image
            assert sum(each() is not None for each in slices) <= 2

    discmc.extract(scan(), 100)
    assert len(slices) == len(ball)


def test_exceptions_of_a_generator_propagate(ball):
    def scan():
        yield ball[0]
        raise OSError("the camera is gone")

    with pytest.raises(OSError, match="camera"):
        discmc.extract(scan(), 100)


def test_labels_share_their_walls():
    labels = np.zeros((8, 9, 10), np.uint16)
    labels[2:5, 2:6, 2:6] = 7
    labels[5:7, 2:6, 2:6] = 300
    meshes = discmc.extract_labels(labels)
    assert list(meshes) == [7, 300]
    assert all(mesh.is_closed for mesh in meshes.values())
    shared = points(meshes[7]) & points(meshes[300])
    assert shared and {point[0] for point in shared} == {4.5}
    assert list(discmc.extract_labels(labels, [300])) == [300]
    assert meshes[7].bounds.tolist() == [[1.5, 1.5, 1.5], [4.5, 5.5, 5.5]]


def test_labels_keep_their_sign_and_all_bits():
    labels = np.zeros((4, 4, 4), np.uint64)
    labels[1, 1, 1] = 2**64 - 1
    assert list(discmc.extract_labels(labels)) == [2**64 - 1]
    assert list(discmc.extract_labels(labels, [2**64 - 1])) == [2**64 - 1]
    assert list(discmc.extract_labels(labels.astype(np.int64))) == [-1]


def test_arrays_outlive_their_mesh(ball):
    mesh = discmc.extract(ball, 100)
    vertices, faces = mesh.vertices, mesh.faces
    expected = vertices.copy(), faces.copy()
    del mesh
    np.zeros((100, 100, 100))
    assert np.array_equal(vertices, expected[0]) and np.array_equal(faces, expected[1])
    with pytest.raises(ValueError):
        vertices[0] = 0


def test_a_mesh_returns_whole_from_another_process(ball):
    options = {"normals": "surface", "polygons": True}
    mesh = discmc.extract(ball, 100, **options)
    with ProcessPoolExecutor(1, multiprocessing.get_context("spawn")) as other:
        returned = other.submit(discmc.extract, ball, 100, **options).result()
    for name in ("vertices", "faces", "normals"):
        assert np.array_equal(getattr(returned, name), getattr(mesh, name))
    assert returned.volume == mesh.volume
    assert len(returned.polygons) == len(mesh.polygons)
    for ours, others in zip(mesh.polygons, returned.polygons):
        assert len(ours) == len(others) and all(map(np.array_equal, ours, others))
    assert np.array_equal(returned.polygons.normals, mesh.polygons.normals)
    assert deepcopy(discmc.extract(ball, 1000)).polygons is None


def test_an_empty_surface_is_a_mesh_without_faces(ball):
    mesh = discmc.extract(ball, 1000)
    assert mesh.vertices.shape == (0, 3) and mesh.faces.shape == (0, 3)
    assert is_closed(np.zeros((1, 3), int))


def test_progress_is_reported_and_can_cancel(ball):
    steps = []
    discmc.extract(ball, 100, progress=lambda step, done, all: steps.append((step, done, all)))
    assert steps[-1] == ("triangulating", 0, 0)
    discmc.extract(iter(ball), 100, progress=lambda step, done, all: steps.append((step, done, all)))
    assert ("extracting", 24, 0) in steps and steps[-1][0] == "triangulating"
    with pytest.raises(discmc.Cancelled):
        discmc.extract(ball, 100, progress=lambda *_: False)
    with pytest.raises(ZeroDivisionError):
        discmc.extract(ball, 100, threads=2, progress=lambda *_: 1 / 0)
    with pytest.raises(discmc.Cancelled):
        discmc.extract(iter(ball), 100, progress=lambda step, *_: step != "triangulating")
    callers = set()
    discmc.extract(ball, 100, threads=3, progress=lambda *_: callers.add(threading.get_ident()))
    assert callers == {threading.get_ident()}


@pytest.mark.parametrize(
    "array, error, remedy",
    [
        (np.zeros((2, 2, 2), ">i2"), TypeError, "newbyteorder"),
        (np.zeros((2, 2, 2), "f2"), TypeError, "float32"),
        (np.zeros((2, 2, 2), "g"), TypeError, "float64"),
        (np.zeros((2, 2, 2), "c8"), TypeError, "complex64.*convert"),
        (np.zeros((2, 2, 2), "O"), TypeError, "object.*convert"),
        (np.zeros((2, 2)), ValueError, "2 axes"),
        (np.zeros((2, 2, 2, 2)), ValueError, r"4 axes.*array\[0\]"),
        (np.zeros((2, 0, 2)), ValueError, "extent is 0; give 1"),
        (np.zeros((2, 2, 2), [("a", "i1"), ("b", "i2")])["b"], ValueError, "ascontiguousarray"),
        (np.zeros((2, 2, 2), {"names": "ab", "formats": ["i2", "i1"], "itemsize": 3})["a"], ValueError,
         "ascontiguousarray"),
        ("head.nrrd", TypeError, r"path 'head.nrrd'; give an array, as discmc.read\(path\)"),
        (np.ma.masked_less(np.arange(8).reshape(2, 2, 2), 3), TypeError, r"array.filled\(value\)"),
    ])
def test_wrong_arrays_are_refused(array, error, remedy):
    with pytest.raises(error, match=remedy):
        discmc.extract(array, 1)


@pytest.mark.parametrize(
    "options, remedy",
    [
        ({"border": "half"}, "border is 'half'; expected 'closed' or 'open'"),
        ({"normals": "flat"}, "normals is 'flat'; expected None or 'surface' or 'gradient'"),
        ({"spacing": (1, 2)}, "give three numbers"),
        ({"spacing": (1, 2, 0)}, "give distances"),
        ({"spacing": (1, 1, 1), "placement": np.eye(4)}, "give one of the two"),
        ({"placement": np.eye(3)}, "give 3 x 4 numbers"),
        ({"placement": np.zeros((3, 4))}, "span no space"),
        ({"threads": -1}, "threads is -1; give 0 or more"),
        ({"threads": 2**32}, "threads is 4294967296; give at most 4294967295"),
        ({"triangles": -1}, "triangles is -1; give 0 or more"),
        ({"tolerance": -1}, "tolerance is -1"),
        ({"upper": 0}, "give numbers in this order"),
        ({"polygons": True, "interpolate": True}, "leave out"),
        ({"normals": "gradient", "upper": 300}, "surface"),
    ])
def test_wrong_options_are_refused(ball, options, remedy):
    with pytest.raises(ValueError, match=remedy):
        discmc.extract(ball, 100, **options)


@pytest.mark.parametrize(
    "options, remedy",
    [
        ({"level": "auto"}, "level is 'auto'; give a number"),
        ({"level": "1"}, "level is '1'; give a number"),
        ({"upper": [1, 2]}, "upper is .*; give a number"),
        ({"smoothing": None}, "smoothing is None; give a number"),
        ({"triangles": 1.5}, "triangles is 1.5; give a whole number"),
    ])
def test_options_of_another_type_are_refused(ball, options, remedy):
    with pytest.raises(TypeError, match=remedy):
        discmc.extract(ball, **{"level": 100, **options})
    with pytest.raises(TypeError, match=remedy):
        discmc.extract(iter(ball), **{"level": 100, **options})


def test_wrong_slices_are_refused(ball):
    with pytest.raises(ValueError, match="no slice; give at least one"):
        discmc.extract(iter(()), 100)
    with pytest.raises(ValueError, match="slice 1 has 3 x 4 samples, the first has 26 x 28"):
        discmc.extract(iter((ball[0], np.zeros((3, 4)))), 100)
    with pytest.raises(ValueError, match="one type"):
        discmc.extract(iter((ball[0], ball[1].astype(np.float32))), 100)
    with pytest.raises(ValueError, match="slice 0 has 3 axes"):
        discmc.extract(iter((ball,)), 100)
    with pytest.raises(ValueError, match="smoothing"):
        discmc.extract(iter(ball), 100, smoothing=1)


def test_wrong_labels_are_refused(ball):
    with pytest.raises(ValueError, match="whole numbers; convert"):
        discmc.extract_labels(ball)
    labels = (ball > 100).astype(np.uint8)
    with pytest.raises(TypeError, match="only has 1.5; give whole numbers"):
        discmc.extract_labels(labels, [1.5])
    with pytest.raises(ValueError, match="labels from"):
        discmc.extract_labels(labels, [2**64])
