import json
import warnings

import numpy as np
import pytest

import discmc
from discmc import _discmc, _plain_files

needs_files = pytest.mark.skipif(not _discmc.has_files, reason="built without the files of the command")


def stl_of(file):
    content = file.read_bytes()
    triangles = np.frombuffer(content, [("normal", "<f4", 3), ("corners", "<f4", (3, 3)), ("", "<u2")],
                              offset=84)
    assert int.from_bytes(content[80:84], "little") == len(triangles)
    return triangles


def test_an_stl_has_the_triangles_of_the_mesh(ball, tmp_path):
    mesh = discmc.extract(ball, 100)
    mesh.write(tmp_path / "ball.stl")
    assert np.array_equal(stl_of(tmp_path / "ball.stl")["corners"], mesh.vertices[mesh.faces])
    assert [file.name for file in tmp_path.iterdir()] == ["ball.stl"]


@needs_files
@pytest.mark.parametrize("extension", "ply obj glb 3mf vtp csv json".split())
def test_a_mesh_is_written_in_each_format_of_the_command(ball, tmp_path, extension):
    file = tmp_path / f"ball.{extension}"
    mesh = discmc.extract(ball, 100, normals="surface")
    mesh.write(str(file))
    assert file.stat().st_size > 100
    if extension == "json":
        (measures,) = json.loads(file.read_text())
        assert measures["volume_mm3"] == pytest.approx(mesh.volume)


def test_stl_ply_and_obj_are_written_without_the_command(ball, tmp_path):
    mesh = discmc.extract(ball, 100)
    _plain_files.write(tmp_path / "plain.stl", ".stl", mesh.vertices, mesh.faces)
    triangles = stl_of(tmp_path / "plain.stl")
    assert np.array_equal(triangles["corners"], mesh.vertices[mesh.faces])
    assert np.allclose(np.linalg.norm(triangles["normal"], axis=1), 1)
    _plain_files.write(tmp_path / "plain.ply", ".PLY", mesh.vertices, mesh.faces)
    header, body = (tmp_path / "plain.ply").read_bytes().split(b"end_header\n")
    assert f"element face {len(mesh.faces)}".encode() in header
    assert np.array_equal(np.frombuffer(body[: mesh.vertices.nbytes], "<f8").reshape(-1, 3), mesh.vertices)
    with pytest.raises(ValueError, match=r"\.stl and \.ply"):
        _plain_files.require_format(tmp_path / "plain.obj")


def test_a_file_that_cannot_be_written_leaves_nothing(ball, tmp_path):
    mesh = discmc.extract(ball, 100)
    with pytest.raises(ValueError, match="stl"):
        mesh.write(tmp_path / "ball.xyz")
    with pytest.raises(FileNotFoundError, match="no such folder; create it: .*nowhere'"):
        mesh.write(tmp_path / "nowhere" / "ball.stl")
    assert list(tmp_path.iterdir()) == []


@needs_files
def test_a_volume_is_read_with_its_place(ball, tmp_path):
    array = ball.astype(np.int16)
    np.save(tmp_path / "ball.npy", array)
    with pytest.warns(discmc.VolumeWarning):
        volume = discmc.read(tmp_path / "ball.npy", spacing=(1, 2, 3))
    assert volume.notes and volume.units == "mm"
    assert repr(volume).startswith("<discmc.Volume: 28 x 26 x 24 voxels, int16, spacing (1")
    assert np.array_equal(volume.array, array.T)
    assert np.array_equal(np.asarray(volume), array.T)
    assert volume.spacing == (1, 2, 3)
    assert volume.affine.tolist() == np.diag([1, 2, 3, 1]).tolist()
    mesh = discmc.extract(volume, 100)
    assert mesh.bounds.tolist() == discmc.extract(array.T, 100, spacing=(1, 2, 3)).bounds.tolist()


@needs_files
def test_scaled_samples_become_values(ball, tmp_path):
    (tmp_path / "ball.raw").write_bytes(ball.clip(0, 255).astype(np.uint8).tobytes())
    (tmp_path / "ball.mhd").write_text(
        "ObjectType = Image\nNDims = 3\nDimSize = 28 26 24\nElementType = MET_UCHAR\n"
        "ElementSpacing = 1 2 3\nOffset = 5 6 7\nElementToIntensityFunctionSlope = 2\n"
        "ElementToIntensityFunctionOffset = -10\nElementDataFile = ball.raw\n")
    with warnings.catch_warnings():
        warnings.simplefilter("ignore", discmc.VolumeWarning)
        volume = discmc.read(tmp_path / "ball.mhd")
    assert volume.affine[:3, 3].tolist() == [5, 6, 7]
    assert volume.array.dtype == np.float32
    assert volume.array.max() == 2 * int(ball.max()) - 10


@needs_files
def test_files_that_are_no_volumes_are_refused(tmp_path):
    with pytest.raises(Exception, match="absent.nii"):
        discmc.read(tmp_path / "absent.nii")


def test_other_libraries_get_the_mesh(ball):
    mesh = discmc.extract(ball, 100, normals="surface")
    for name, convert in (("trimesh", mesh.to_trimesh), ("pyvista", mesh.to_pyvista)):
        try:
            __import__(name)
        except ImportError:
            with pytest.raises(ImportError):
                convert()
        else:
            assert convert().volume == pytest.approx(mesh.volume, rel=1e-4)


@needs_files
def test_a_missing_file_is_named(tmp_path):
    with pytest.raises(FileNotFoundError, match="there is no such file"):
        discmc.read(tmp_path / "nofile.nrrd")
