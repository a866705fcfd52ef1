"""Measures surfaces of the command discmc beside scikit-image and VTK, where these are installed.

usage: surfaces.py DISCMC FOLDER; FOLDER gets volumes and meshes. Prints tables in Markdown.
`scripts/bench --surfaces` builds the command and runs this. Distances are measured by discmc compare.
"""

import os
import resource
import subprocess
import sys

import numpy as np
from scipy import ndimage

try:
    from skimage.measure import marching_cubes
except ImportError:
    marching_cubes = None
try:
    import vtk
    from vtk.util.numpy_support import numpy_to_vtk, vtk_to_numpy
except ImportError:
    vtk = None

DISCMC, FOLDER = os.path.abspath(sys.argv[1]), sys.argv[2]


def run(*arguments):
    """Returns the output, and seconds of processor time."""
    before = resource.getrusage(resource.RUSAGE_CHILDREN)
    done = subprocess.run([DISCMC, *arguments], cwd=FOLDER, check=True, capture_output=True, text=True)
    after = resource.getrusage(resource.RUSAGE_CHILDREN)
    return done.stdout, after.ru_utime - before.ru_utime + after.ru_stime - before.ru_stime


def extracted(volume, spacing, *options):
    """Returns vertices, normals (or none), triangles and seconds."""
    _, seconds = run('extract', volume, '--spacing', ','.join(map(str, spacing)), *options, '-o', 'mesh.ply')
    with open(os.path.join(FOLDER, 'mesh.ply'), 'rb') as file:
        header = b''
        while not header.endswith(b'end_header\n'):
            header += file.readline()
        counts = [int(line.split()[2]) for line in header.splitlines() if line.startswith(b'element')]
        columns = header.count(b'property float')
        rows = np.fromfile(file, '<f4', counts[0] * columns).reshape(-1, columns).astype(float)
        faces = np.fromfile(file, np.dtype([('count', 'u1'), ('corners', '<i4', 3)]), counts[1])
    return rows[:, :3], rows[:, 3:6] if columns > 3 else None, faces['corners'], seconds


def crosses(vertices, triangles):
    a, b, c = (vertices[triangles[:, i]] for i in range(3))
    return np.cross(b - a, c - a)


def thin(vertices, triangles):
    """Percent of triangles with an angle below 5 degrees."""
    corners = vertices[triangles]
    sides = np.roll(corners, -1, 1) - corners
    lengths = np.maximum(np.linalg.norm(sides, axis=2), 1e-300)
    cosines = [-np.einsum('ij,ij->i', sides[:, i], sides[:, i - 1]) / lengths[:, i] / lengths[:, i - 1]
               for i in range(3)]
    return 100 * np.mean(np.max(cosines, axis=0) > np.cos(np.radians(5)))


def degrees(vectors, radii):
    cosines = np.einsum('ij,ij->i', vectors, radii) / np.linalg.norm(vectors, axis=1) / np.linalg.norm(radii, axis=1)
    return np.degrees(np.arccos(np.clip(cosines, -1, 1)))


def of_vtk(samples, spacing, level):
    image = vtk.vtkImageData()
    image.SetDimensions(samples.shape[::-1])
    image.SetSpacing(spacing)
    image.GetPointData().SetScalars(numpy_to_vtk(samples.astype(np.float32).ravel()))
    surface = vtk.vtkFlyingEdges3D()
    surface.SetInputData(image)
    surface.SetValue(0, level)
    surface.ComputeNormalsOff()
    surface.Update()
    mesh = surface.GetOutput()
    return vtk_to_numpy(mesh.GetPoints().GetData()).astype(float), vtk_to_numpy(
        mesh.GetPolys().GetConnectivityArray()).reshape(-1, 3)


def of_skimage(samples, spacing, level):
    vertices, triangles, _, _ = marching_cubes(samples, level, spacing=spacing[::-1], allow_degenerate=False)
    return vertices[:, ::-1].astype(float), triangles


OTHERS = [(name, make) for name, make, module in (('VTK FlyingEdges3D', of_vtk, vtk),
                                                  ('scikit-image', of_skimage, marching_cubes)) if module]


def ball(extent, spacing, radius):
    """Returns the distances to its surface, positive inside, and its middle."""
    shape = [round(extent / step) for step in spacing]
    middle = np.array([(count - 1) / 2 * step + 0.1 for count, step in zip(shape, spacing)])
    z, y, x = np.ogrid[:shape[2], :shape[1], :shape[0]]
    return radius - np.sqrt(sum((axis * step - at) ** 2 for axis, step, at in zip((x, y, z), spacing, middle))), middle


def bench_mask():
    spacing, radius = (1, 1, 3), 20
    inside, middle = ball(60, spacing, radius)
    np.save(f'{FOLDER}/mask.npy', (inside >= 0).astype(np.uint8))
    print('| mask of a ball, radius 20 mm, voxels of 1 x 1 x 3 mm | area | normals of faces, mean error | largest |\n|---|--:|--:|--:|')

    def row(name, vertices, triangles):
        cross = crosses(vertices, triangles)
        areas = np.linalg.norm(cross, axis=1) / 2
        keep = areas > 0
        error = degrees(cross[keep], vertices[triangles].mean(1)[keep] - middle)
        print(f'| {name} | {100 * (areas.sum() / (4 * np.pi * radius ** 2) - 1):+.1f} % '
              f'| {np.average(error, weights=areas[keep]):.1f} | {error.max():.0f} |')

    for name, options in (('discmc', ()), ('discmc --smooth auto', ('--smooth', 'auto')),
                          ('discmc --smooth 1.5', ('--smooth', '1.5'))):
        vertices, _, triangles, _ = extracted('mask.npy', spacing, '--iso', '1', *options)
        row(name, vertices, triangles)
    for name, make in OTHERS:
        row(name, *make((inside >= 0).astype(np.float32), spacing, 0.5))
    print()


def bench_normals():
    print('| `--normals surface` of a ball, radius 20 mm | mean error | largest |\n|---|--:|--:|')
    for spacing in ((1, 1, 1), (0.5, 0.7, 2)):
        inside, middle = ball(60, spacing, 20)
        np.save(f'{FOLDER}/ball.npy', inside.astype(np.float32))
        for name, surface in (('merged', 'merged'), ('interpolated', 'interpolated')):
            vertices, normals, _, _ = extracted('ball.npy', spacing, '--iso', '0', '--surface', surface,
                                                '--normals', 'surface')
            error = degrees(normals, vertices - middle)
            print(f'| {name}, voxels of {" x ".join(map(str, spacing))} mm | {error.mean():.1f} | {error.max():.0f} |')
    print()


def bench_noise(extent):
    samples = ndimage.gaussian_filter(np.random.default_rng(1).standard_normal((extent,) * 3, np.float32), 6, mode='wrap')
    np.save(f'{FOLDER}/noise.npy', samples)
    print(f'| noise, blurred over 6 voxels, {extent}^3, at 0 | triangles | mean distance, voxels | an angle below 5 degrees | s |\n|---|--:|--:|--:|--:|')
    for options in (('--surface', 'merged'), ('--surface', 'interpolated'),
                    ('--surface', 'interpolated', '--tolerance', '0.01'), ('--triangles', str(extent ** 3 // 50)),
                    ('--triangles', str(extent ** 3 // 100)), ('--max-error', '0.02')):
        vertices, _, triangles, seconds = extracted('noise.npy', (1, 1, 1), '--iso', '0', *options)
        told, _ = run('compare', 'mesh.ply', 'noise.npy', '--iso', '0', '--spacing', '1,1,1')
        mean = next(line.split()[4] for line in told.splitlines() if 'A to B' in line)
        print(f'| discmc {" ".join(options)} | {len(triangles):,} | {mean} | {thin(vertices, triangles):.1f} % | {seconds:.1f} |')
    for name, make in OTHERS:
        vertices, triangles = make(samples, (1, 1, 1), 0)
        print(f'| {name} | {len(triangles):,} | 0 | {thin(vertices, triangles):.1f} % | |')
    print()


def bench_labels(extent):
    seeds = np.random.default_rng(2).uniform(0, extent, (354, 3))
    grid = np.zeros((extent,) * 3, np.uint16)
    centres = np.full(grid.shape, True)
    for number, seed in enumerate(seeds, 1):
        at = tuple(seed.astype(int))
        grid[at], centres[at] = number, False
    nearest = ndimage.distance_transform_edt(centres, return_distances=False, return_indices=True)
    np.save(f'{FOLDER}/labels.npy', grid[tuple(nearest)])
    print(f'| {len(seeds)} labels of {extent}^3 to one .glb | s |\n|---|--:|')
    for options in ((), ('--smooth', 'auto'), ('--smooth', 'auto', '--max-error', '0.05')):
        _, seconds = run('extract', 'labels.npy', '--spacing', '1,1,1', '--labels', 'all', *options, '-o', 'labels.glb')
        print(f'| discmc {" ".join(options)} | {seconds:.1f} |')


EXTENT = int(sys.argv[3]) if len(sys.argv) > 3 else 256
bench_mask()
bench_normals()
bench_noise(EXTENT)
bench_labels(EXTENT)
