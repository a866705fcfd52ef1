"""The surfaces of other libraries, where they are installed."""

import numpy as np
import pytest
from conftest import ball_of, euler_characteristic, is_closed, signed_volume, surface_area

import discmc


def blurred(seed, shape=(30, 31, 32)):
    """Noise without samples near the level 0, surrounded by voxels outside."""
    volume = np.random.default_rng(seed).normal(size=shape)
    for axis in range(3):
        for _ in range(4):
            volume = (volume + np.roll(volume, 1, axis)) / 2
    volume = volume / np.abs(volume).max()
    volume += np.copysign(0.02, volume)
    return np.pad(volume, 1, constant_values=-1).astype(np.float32)


def test_marching_cubes_equals_that_of_scikit_image():
    other = pytest.importorskip("skimage.measure").marching_cubes
    for volume, level in ((ball_of(), 101.3), (blurred(1), 0), (blurred(2)[5:-5, 4:, :-3], 0)):
        for options in ({}, {"gradient_direction": "ascent"}, {"spacing": (0.5, 2.0, 3.0)}, {"step_size": 2}):
            theirs = other(volume, level, **options)
            ours = discmc.marching_cubes(volume, level, **options)
            for their, our in zip(theirs, ours):
                assert our.dtype == their.dtype and our.ndim == their.ndim
            spacing = np.array(options.get("spacing", (1, 1, 1)))
            near = 0.1 * options.get("step_size", 1)
            for edge in (np.min, np.max):
                assert edge(ours[0] / spacing, axis=0) == pytest.approx(
                    edge(theirs[0] / spacing, axis=0), abs=near)
            assert surface_area(*ours[:2]) == pytest.approx(surface_area(*theirs[:2]), rel=0.03)
            if is_closed(theirs[1]):
                assert is_closed(ours[1])
                assert signed_volume(*ours[:2]) == pytest.approx(signed_volume(*theirs[:2]), rel=0.02)


def test_without_tolerance_the_vertices_and_values_are_those_of_scikit_image():
    other = pytest.importorskip("skimage.measure").marching_cubes
    spatial = pytest.importorskip("scipy.spatial")
    volume = ball_of()
    theirs = other(volume, 101.3)
    ours = discmc.marching_cubes(volume, 101.3, tolerance=0)
    distances, nearest = spatial.cKDTree(ours[0]).query(theirs[0])
    assert distances.max() < 1 / 64
    assert ours[3][nearest] == pytest.approx(theirs[3], abs=1e-3)
    assert np.einsum("ij,ij->i", ours[2][nearest], theirs[2]).min() > 0.98
    assert euler_characteristic(ours[1]) == euler_characteristic(theirs[1]) == 2


def test_the_levels_are_those_of_scikit_image():
    other = pytest.importorskip("skimage.measure").marching_cubes
    volume = ball_of()
    assert discmc.marching_cubes(volume)[0].mean(0) == pytest.approx(other(volume)[0].mean(0), abs=0.3)
    mask = volume > 100
    theirs, ours = other(mask), discmc.marching_cubes(mask)
    assert ours[0].max(0).tolist() == theirs[0].max(0).tolist()
    assert abs(signed_volume(*ours[:2])) == pytest.approx(abs(signed_volume(*theirs[:2])), rel=0.02)
    for level in (volume.min() - 1, volume.max() + 1):
        with pytest.raises(ValueError):
            other(volume, level)
        with pytest.raises(ValueError, match="give one within"):
            discmc.marching_cubes(volume, level)


@pytest.mark.parametrize("dtype", ["<f2", ">f4", ">i2"])
def test_marching_cubes_copies_samples_that_the_library_lacks(dtype):
    volume = ball_of().astype(dtype)
    expected = discmc.marching_cubes(volume.astype("f4" if dtype == "<f2" else dtype[1:]), 101)
    for ours, theirs in zip(discmc.marching_cubes(volume, 101), expected):
        assert np.array_equal(ours, theirs)


def vtk_surface(volume, level):
    core = pytest.importorskip("vtkmodules.vtkFiltersCore")
    from vtkmodules.util import numpy_support
    from vtkmodules.vtkCommonDataModel import vtkImageData

    image = vtkImageData()
    image.SetDimensions(volume.shape[::-1])
    image.GetPointData().SetScalars(numpy_support.numpy_to_vtk(np.ascontiguousarray(volume).reshape(-1)))
    edges = core.vtkFlyingEdges3D()
    edges.SetInputData(image)
    edges.SetValue(0, level)
    edges.Update()
    output = edges.GetOutput()
    vertices = numpy_support.vtk_to_numpy(output.GetPoints().GetData())[:, ::-1]
    return vertices, numpy_support.vtk_to_numpy(output.GetPolys().GetConnectivityArray()).reshape(-1, 3)


@pytest.mark.parametrize("seed", [3, 4])
def test_extract_is_as_large_as_the_surface_of_vtk(seed):
    for volume, level in ((blurred(seed), 0), (np.pad(ball_of(), 1), 101.3)):
        vertices, faces = vtk_surface(volume, level)
        mesh = discmc.extract(volume, level, interpolate=True)
        assert mesh.is_closed and is_closed(mesh.faces) and is_closed(faces)
        assert mesh.bounds == pytest.approx(np.array([vertices.min(0), vertices.max(0)]), abs=0.1)
        assert mesh.area == pytest.approx(surface_area(vertices, faces), rel=0.03)
        assert mesh.volume == pytest.approx(abs(signed_volume(vertices, faces)), rel=0.02)


@pytest.mark.parametrize(
    "options, remedy",
    [
        ({"mask": np.ones((24, 26, 28), bool)}, "mask is not supported; copy"),
        ({"method": "lorensen"}, "'lorensen'; only the default"),
        ({"gradient_direction": "up"}, "'up'; expected 'descent' or 'ascent'"),
        ({"step_size": 0}, "step_size is 0; give"),
        ({"step_size": 1.5}, "step_size is 1.5; give"),
        ({"spacing": (1, 2)}, "give three numbers"),
    ])
def test_wrong_options_are_refused(ball, options, remedy):
    with pytest.raises(ValueError, match=remedy):
        discmc.marching_cubes(ball, 100, **options)


def test_degenerate_triangles_are_left_out_on_request(ball):
    vertices, faces, *_ = discmc.marching_cubes(np.round(ball), 100, allow_degenerate=False)
    a, b, c = np.moveaxis(vertices[faces].astype(float), 1, 0)
    assert (np.linalg.norm(np.cross(b - a, c - a), axis=1) > 0).all()
