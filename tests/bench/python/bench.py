"""Compares the times of the Python package, scikit-image, VTK, PyMCubes and zmesh, if installed.

usage: bench.py [FOLDER]; FOLDER has volumes, each with a JSON file of its name that lists thresholds.
`scripts/bench --python` builds the package and runs this. Prints tables in Markdown.

Each call is in a process of its own, on one core, in turns. Seconds: processor time, which other programs
change little; the least of the rounds. Memory: the peak during the call, above what the process had with the
array. Distance: the mean, in voxels, from points of the mesh to vtkFlyingEdges3D's mesh of the padded array.
"""

import json
import os
import subprocess
import sys
import tempfile
from pathlib import Path

ROUNDS = 3
POINTS = 20000  # samples for the mean distance


def memory(field):
    """Bytes of this process from /proc: VmRSS now, VmHWM at the peak."""
    for line in open('/proc/self/status'):
        if line.startswith(field):
            return int(line.split()[1]) * 1024
    raise LookupError(field)


# ---- Contenders: each imports what it needs, and returns a call, which returns vertices and triangles. The
# ---- coordinates of a vertex are in the order of the array's axes. Calls of labels return the number of triangles.


def arrays_of(mesh):
    return mesh.vertices, mesh.faces


def extract(array, level):
    import discmc

    return lambda: arrays_of(discmc.extract(array, level))


def extract_interpolated(array, level):
    import discmc

    return lambda: arrays_of(discmc.extract(array, level, interpolate=True))


def marching_cubes(array, level):
    import discmc

    return lambda: discmc.marching_cubes(array, level)[:2]


def scikit_image(array, level):
    from skimage.measure import marching_cubes as other

    return lambda: other(array, level)[:2]


def vtk_image(array):
    from vtkmodules.util import numpy_support
    from vtkmodules.vtkCommonDataModel import vtkImageData

    image = vtkImageData()
    image.SetDimensions(array.shape[::-1])
    image.GetPointData().SetScalars(numpy_support.numpy_to_vtk(array.reshape(-1)))
    return image


def vtk_mesh(algorithm):
    """Runs the call, and converts its points and triangles to NumPy."""
    from vtkmodules.util import numpy_support

    algorithm.Update()
    output = algorithm.GetOutput()
    points = numpy_support.vtk_to_numpy(output.GetPoints().GetData())[:, ::-1]
    return points, numpy_support.vtk_to_numpy(output.GetPolys().GetConnectivityArray()).reshape(-1, 3)


def vtk_flying_edges(array, level):
    from vtkmodules.vtkFiltersCore import vtkFlyingEdges3D

    def call():
        edges = vtkFlyingEdges3D()
        edges.SetInputData(vtk_image(array))
        edges.SetValue(0, level)
        edges.ComputeNormalsOff()
        return vtk_mesh(edges)

    return call


def pymcubes(array, level):
    import mcubes

    return lambda: mcubes.marching_cubes(array, level)


def extract_labels(array, level):
    import discmc

    return lambda: sum(len(mesh.faces) for mesh in discmc.extract_labels(array).values())


def vtk_discrete_flying_edges(array, level):
    import numpy as np
    from vtkmodules.vtkFiltersGeneral import vtkDiscreteFlyingEdges3D

    def call():
        edges = vtkDiscreteFlyingEdges3D()
        edges.SetInputData(vtk_image(array))
        for place, label in enumerate(np.unique(array)[1:]):
            edges.SetValue(place, label)
        edges.ComputeNormalsOff()
        return len(vtk_mesh(edges)[1])

    return call


def scikit_image_labels(array, level):
    import numpy as np
    from skimage.measure import marching_cubes as other

    return lambda: sum(len(other(array == label, 0.5)[1]) for label in np.unique(array)[1:])


def zmesh_labels(array, level):
    import zmesh

    def call():
        mesher = zmesh.Mesher((1, 1, 1))
        mesher.mesh(array)
        return sum(len(mesher.get(label).faces) for label in mesher.ids())

    return call


OF_LEVELS = {
    'discmc.extract()': extract,
    'discmc.extract(interpolate=True)': extract_interpolated,
    'discmc.marching_cubes()': marching_cubes,
    'scikit-image marching_cubes': scikit_image,
    'VTK vtkFlyingEdges3D': vtk_flying_edges,
    'PyMCubes': pymcubes,
}
OF_LABELS = {
    'discmc.extract_labels()': extract_labels,
    'scikit-image marching_cubes, each label': scikit_image_labels,
    'VTK vtkDiscreteFlyingEdges3D': vtk_discrete_flying_edges,
    'zmesh': zmesh_labels,
}


def mean_distance(vertices, faces, array, level):
    """The mean distance of points of the mesh from the surface of the samples. Units: voxels."""
    import numpy as np
    from vtkmodules.vtkCommonCore import mutable
    from vtkmodules.vtkCommonDataModel import vtkCellLocator
    from vtkmodules.vtkFiltersCore import vtkFlyingEdges3D

    edges = vtkFlyingEdges3D()
    edges.SetInputData(vtk_image(np.pad(array, 1, constant_values=array.min())))
    edges.SetValue(0, level)
    edges.Update()
    locator = vtkCellLocator()
    locator.SetDataSet(edges.GetOutput())
    locator.BuildLocator()

    corners = vertices[faces].astype(float)
    areas = np.linalg.norm(np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0]), axis=1)
    random = np.random.default_rng(1)
    chosen = corners[random.choice(len(areas), POINTS, p=areas / areas.sum())]
    points = np.einsum('ij,ijk->ik', random.dirichlet((1, 1, 1), POINTS), chosen) + 1
    closest, cell, part, squared = [0, 0, 0], mutable(0), mutable(0), mutable(0.0)
    distances = []
    for point in points[:, ::-1]:
        locator.FindClosestPoint(point, closest, cell, part, squared)
        distances.append(squared.get() ** 0.5)
    return float(np.mean(distances))


def measure(name, file, level):
    """Prints seconds, bytes, triangles and distance of one call; nothing if its library is not installed."""
    import numpy as np

    os.sched_setaffinity(0, {min(os.sched_getaffinity(0))})
    array = np.load(file)
    try:
        call = (OF_LEVELS | OF_LABELS)[name](array, level)
        # Excludes what libraries initialise at their first call.
        (OF_LEVELS | OF_LABELS)[name](np.ascontiguousarray(array[:8, :8, :8] // 2 * 0 + np.arange(
            8, dtype=array.dtype)), 4)()
    except ImportError:
        return
    import time

    with open('/proc/self/clear_refs', 'w') as peak:
        peak.write('5')  # the peak from now on
    before = memory('VmRSS')
    begin = time.process_time()
    found = call()
    seconds = time.process_time() - begin
    peak = memory('VmHWM') - before
    if name in OF_LABELS:
        print(json.dumps([seconds, peak, found, None]))
    else:
        print(json.dumps([seconds, peak, len(found[1]), mean_distance(*found, array, level)]))


# ---- Volumes


def generated(size, kind):
    """A gyroid whose period shrinks along an axis, with values around 128."""
    import numpy as np

    steps = np.linspace(0, 1, size, dtype=np.float32)
    x, y, z = (steps * 40, steps.reshape(-1, 1) * 40, steps.reshape(-1, 1, 1) * 40)
    volume = np.sin(x) * np.cos(y) + np.sin(y) * np.cos(z) + np.sin(z) * np.cos(x)
    return np.ascontiguousarray((volume * 80 + 128).astype(kind))


def labelled(size, count):
    """Each voxel has the number of the nearest of some points."""
    import numpy as np
    from scipy.spatial import cKDTree

    points = np.random.default_rng(1).random((count, 3)) * size
    voxels = np.stack(np.meshgrid(*3 * [np.arange(size)], indexing='ij'), -1).reshape(-1, 3)
    return (cKDTree(points).query(voxels)[1] + 1).reshape(3 * [size]).astype(np.uint16)


def volumes(folder):
    """Name, array, levels; no levels for labels. With levels between integers, all programs have the same on voxels."""
    import numpy as np

    for file in sorted(Path(folder).glob('*.json')) if folder else []:
        import discmc

        about = json.loads(file.read_text())
        array = np.ascontiguousarray(np.asarray(discmc.read(file.parent / about['file'])).T)
        if array.size > 2**20:
            level = about['iso'][0] - (0.5 if array.dtype.kind in 'iu' else 0)
            extents = ' x '.join(map(str, array.shape[::-1]))
            yield f'{about["name"]}, {extents} {array.dtype}, at {level}', array, [level]
    yield '300 labels, 256^3 uint16', labelled(256, 300), []
    for size in (256, 512):
        for kind in ('uint8', 'float32'):
            yield f'gyroid, {size}^3 {kind}, at 128.5', generated(size, kind), [128.5]


def run(file, level, names):
    rounds = {name: [] for name in names}
    for _ in range(ROUNDS):
        for name in names:
            found = subprocess.run([sys.executable, __file__, 'measure', name, file, str(level)],
                                   stdout=subprocess.PIPE, check=True).stdout
            if found:
                rounds[name].append(json.loads(found))
    return {name: found for name, found in rounds.items() if found}


def main(folder=None):
    print('| volume | call | seconds | MB above the array | triangles | mean distance, voxels |')
    print('|---|---|--:|--:|--:|--:|')
    import numpy as np

    with tempfile.TemporaryDirectory() as scratch:
        file = os.path.join(scratch, 'volume.npy')
        for title, array, levels in volumes(folder):
            np.save(file, array)
            del array
            for name, found in run(file, (levels or [0])[0], OF_LEVELS if levels else OF_LABELS).items():
                seconds = min(each[0] for each in found)
                megabytes = min(each[1] for each in found) / 1e6
                distance = '' if found[0][3] is None else f'{found[0][3]:.3f}'
                print(f'| {title} | {name} | {seconds:.2f} | {megabytes:,.0f} | {found[0][2]:,} | {distance} |',
                      flush=True)
                title = ''


if __name__ == '__main__':
    if sys.argv[1:2] == ['measure']:
        measure(sys.argv[2], sys.argv[3], float(sys.argv[4]))
    else:
        main(*sys.argv[1:])
