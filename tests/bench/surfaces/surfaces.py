"""Compares the surfaces of the command discmc, scikit-image, VTK and nii2mesh, if installed.

usage: surfaces.py DISCMC FOLDER; FOLDER gets volumes and meshes. Prints tables in Markdown.
`scripts/bench --surfaces` builds the command and runs this. Distances are measured by discmc compare.
"""

import json
import os
import sys
import zlib

import numpy as np
from scipy import ndimage

from contenders import others, usage_of

DISCMC, FOLDER = os.path.abspath(sys.argv[1]), sys.argv[2]


def read_ply(name):
    """Returns vertices and normals as columns, and triangles."""
    with open(os.path.join(FOLDER, name), 'rb') as file:
        header = b''
        while not header.endswith(b'end_header\n'):
            header += file.readline()
        counts = [int(line.split()[2]) for line in header.splitlines() if line.startswith(b'element')]
        number = '<f8' if b'property double' in header else '<f4'
        columns = header.count(b'property float') + header.count(b'property double')
        rows = np.fromfile(file, number, counts[0] * columns).reshape(-1, columns).astype(float)
        faces = np.fromfile(file, np.dtype([('count', 'u1'), ('corners', '<i4', 3)]), counts[1])
    return rows, faces['corners']


def write_ply(name, vertices, triangles):
    faces = np.zeros(len(triangles), np.dtype([('count', 'u1'), ('corners', '<i4', 3)]))
    faces['count'], faces['corners'] = 3, triangles
    header = (f'ply\nformat binary_little_endian 1.0\nelement vertex {len(vertices)}\nproperty float x\n'
              f'property float y\nproperty float z\nelement face {len(faces)}\n'
              'property list uchar int vertex_indices\nend_header\n')
    with open(os.path.join(FOLDER, name), 'wb') as file:
        file.write(header.encode() + vertices.astype('<f4').tobytes() + faces.tobytes())


def extracted(*volume_and_options):
    """Returns vertices, normals (or None), triangles, seconds and MB."""
    _, seconds, megabytes = usage_of([DISCMC, 'extract', *volume_and_options, '-o', 'mesh.ply'], FOLDER)
    rows, triangles = read_ply('mesh.ply')
    return rows[:, :3], rows[:, 3:6] if rows.shape[1] > 3 else None, triangles, seconds, megabytes


def spaced(spacing):
    return '--spacing', ','.join(map(str, spacing))


def wrong_edges(triangles):
    """Returns the edges that are not used by two triangles in opposite directions."""
    starts, ends = triangles.ravel().astype(np.int64), np.roll(triangles, -1, 1).ravel().astype(np.int64)
    edges, place = np.unique(np.minimum(starts, ends) << 32 | np.maximum(starts, ends), return_inverse=True)
    uses = np.bincount(place, minlength=len(edges))
    rising = np.bincount(place, weights=starts < ends, minlength=len(edges))
    return int(np.sum((uses != 2) | (rising != 1)))


def crosses(vertices, triangles):
    a, b, c = (vertices[triangles[:, i]] for i in range(3))
    return np.cross(b - a, c - a)


def thin(vertices, triangles):
    """Returns the percentage of triangles with an angle below 5 degrees."""
    corners = vertices[triangles]
    sides = np.roll(corners, -1, 1) - corners
    lengths = np.maximum(np.linalg.norm(sides, axis=2), 1e-300)
    cosines = [-np.einsum('ij,ij->i', sides[:, i], sides[:, i - 1]) / lengths[:, i] / lengths[:, i - 1]
               for i in range(3)]
    return 100 * np.mean(np.max(cosines, axis=0) > np.cos(np.radians(5)))


def degrees(vectors, radii):
    cosines = np.einsum('ij,ij->i', vectors, radii) / np.linalg.norm(vectors, axis=1) / np.linalg.norm(radii, axis=1)
    return np.degrees(np.arccos(np.clip(cosines, -1, 1)))


def ball(extent, spacing, radius):
    """Returns the distances from the surface, positive inside, and the centre."""
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
        vertices, _, triangles, _, _ = extracted('mask.npy', *spaced(spacing), '--iso', '1', *options)
        row(name, vertices, triangles)
    for name, vertices, triangles, _, _ in others((inside >= 0).astype(np.float32), spacing, 0.5, FOLDER, read_ply):
        row(name, vertices, triangles)
    print()


def bench_normals():
    print('| `--normals surface` of a ball, radius 20 mm | mean error | largest |\n|---|--:|--:|')
    for spacing in ((1, 1, 1), (0.5, 0.7, 2)):
        inside, middle = ball(60, spacing, 20)
        np.save(f'{FOLDER}/ball.npy', inside.astype(np.float32))
        for name, surface in (('merged', 'merged'), ('interpolated', 'interpolated')):
            vertices, normals, _, _, _ = extracted('ball.npy', *spaced(spacing), '--iso', '0', '--surface', surface,
                                                '--normals', 'surface')
            error = degrees(normals, vertices - middle)
            print(f'| {name}, voxels of {" x ".join(map(str, spacing))} mm | {error.mean():.1f} | {error.max():.0f} |')
    print()


def bench_samples(title, samples, spacing, level):
    """Surrounds the samples by their minimum, so that every program closes the surface."""
    closed = np.pad(samples, 1, constant_values=samples.min())
    np.save(f'{FOLDER}/closed.npy', closed)
    volume = ('closed.npy', *spaced(spacing), '--iso', str(level))
    print(f'| {title} | triangles | mean distance, mm | largest | an angle below 5 degrees | wrong edges | s | MB |\n'
          '|---|--:|--:|--:|--:|--:|--:|--:|')

    def row(name, vertices, triangles, seconds, megabytes):
        output, _, _ = usage_of([DISCMC, 'compare', 'mesh.ply', *volume], FOLDER)
        distances = next(line.split() for line in output.splitlines() if 'A to B, mm' in line)
        print(f'| {name} | {len(triangles):,} | {distances[4]} | {distances[6]} | {thin(vertices, triangles):.1f} % '
              f'| {wrong_edges(triangles):,} | {seconds:.1f} | {f"{megabytes:.0f}" if megabytes else ""} |', flush=True)

    fewer = None
    for options in ((), ('--surface', 'interpolated'), ('--triangles',)):
        if options == ('--triangles',):
            options = ('--triangles', str(int(fewer * 0.6)))
        vertices, _, triangles, seconds, megabytes = extracted(*volume, *options)
        fewer = len(triangles)
        row(' '.join(('discmc', *options)), vertices, triangles, seconds, megabytes)
    # discmc crosses between integers.
    crossing = level - 0.5 if closed.dtype.kind in 'iu' else level
    for name, vertices, triangles, seconds, megabytes in others(closed, spacing, crossing, FOLDER, read_ply):
        write_ply('mesh.ply', vertices, triangles)
        row(name, vertices, triangles, seconds, megabytes)
    print()


def bench_noise(extent, blur):
    samples = ndimage.gaussian_filter(np.random.default_rng(1).standard_normal((extent,) * 3, np.float32), blur,
                                      mode='wrap')
    bench_samples(f'noise, blurred over {blur:g} voxels, {extent}^3, at 0', samples, (1, 1, 1), 0)


def read_scan(path, scan):
    """Returns the samples of a compressed NIfTI or NRRD file with the dimensions and type of `scan`."""
    with open(path, 'rb') as file:
        content = file.read()
    packed = content if '.nii' in path else content.partition(b'\n\n')[2]
    type_of_sample = np.dtype(scan['type'][0] + str(int(scan['type'][1:]) // 8))
    count = np.prod(scan['dims'])
    samples = zlib.decompress(packed, 47)[-count * type_of_sample.itemsize:]
    return np.frombuffer(samples, type_of_sample).reshape(scan['dims'][::-1])


def bench_scans(folder):
    for name in ('engine', 'cthead', 'mri_head_seg3d'):
        if os.path.exists(f'{folder}/{name}.json'):
            with open(f'{folder}/{name}.json', encoding='utf-8') as file:
                scan = json.load(file)
            bench_samples(f'{scan["file"]}, at {scan["iso"][0]}', read_scan(f'{folder}/{scan["file"]}', scan),
                          scan['spacing'], scan['iso'][0])


def bench_labels(extent):
    seeds = np.random.default_rng(2).uniform(0, extent, (354, 3))
    grid = np.zeros((extent,) * 3, np.uint16)
    centres = np.full(grid.shape, True)
    for number, seed in enumerate(seeds, 1):
        at = tuple(seed.astype(int))
        grid[at], centres[at] = number, False
    nearest = ndimage.distance_transform_edt(centres, return_distances=False, return_indices=True)
    np.save(f'{FOLDER}/labels.npy', grid[tuple(nearest)])
    print(f'| {len(seeds)} labels of {extent}^3 to one .glb | s | MB |\n|---|--:|--:|')
    for options in ((), ('--smooth', 'auto'), ('--smooth', 'auto', '--max-error', '0.05')):
        _, seconds, megabytes = usage_of([DISCMC, 'extract', 'labels.npy', '--spacing', '1,1,1', '--labels', 'all',
                                          *options, '-o', 'labels.glb'], FOLDER)
        print(f'| discmc {" ".join(options)} | {seconds:.1f} | {megabytes:.0f} |')


EXTENT = int(sys.argv[3]) if len(sys.argv) > 3 else 256
bench_mask()
bench_normals()
for width in (18, 6):
    bench_noise(EXTENT, width * EXTENT / 256)
bench_scans(os.environ.get('DISCMC_DATA', ''))
bench_labels(EXTENT)
