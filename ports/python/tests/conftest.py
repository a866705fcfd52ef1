import numpy as np
import pytest


def ball_of(shape=(24, 26, 28), centre=(11.0, 12.5, 13.0), radius=8.2):
    """Samples that fall by 10 per voxel from the surface of a ball, where they are 100."""
    axes = np.ogrid[tuple(slice(0, extent) for extent in shape)]
    distances = np.sqrt(sum((axis - place) ** 2 for axis, place in zip(axes, centre)))
    return 100 + 10 * (radius - distances)


@pytest.fixture
def ball():
    return ball_of()


def signed_volume(vertices, faces):
    a, b, c = np.moveaxis(vertices[faces].astype(float), 1, 0)
    return np.einsum("ij,ij->i", a, np.cross(b, c)).sum() / 6


def surface_area(vertices, faces):
    a, b, c = np.moveaxis(vertices[faces].astype(float), 1, 0)
    return np.linalg.norm(np.cross(b - a, c - a), axis=1).sum() / 2


def edges_of(faces):
    return np.concatenate([faces[:, [0, 1]], faces[:, [1, 2]], faces[:, [2, 0]]]).astype(np.int64)


def is_closed(faces):
    """Whether every edge is used as often in one direction as in the other."""
    edges = edges_of(faces)
    count = int(faces.max()) + 1
    there, back = edges[:, 0] * count + edges[:, 1], edges[:, 1] * count + edges[:, 0]
    return np.array_equal(np.sort(there), np.sort(back))


def euler_characteristic(faces):
    edges = np.unique(np.sort(edges_of(faces), axis=1), axis=0)
    return len(np.unique(faces)) - len(edges) + len(faces)
