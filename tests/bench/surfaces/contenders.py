"""Makes the meshes of other programs for surfaces.py, if the programs are installed."""

import shutil
import subprocess
import sys
import time

import numpy as np

try:
    from skimage.measure import marching_cubes
except ImportError:
    marching_cubes = None
try:
    import vtk
    from vtk.util.numpy_support import numpy_to_vtk, vtk_to_numpy
except ImportError:
    vtk = None

NII2MESH = shutil.which('nii2mesh')


# In another process, because the memory of this one would count as that of its children.
MEASURED = """
import resource, subprocess, sys
status = subprocess.call(sys.argv[1:], stderr=subprocess.DEVNULL)
usage = resource.getrusage(resource.RUSAGE_CHILDREN)
print(usage.ru_utime + usage.ru_stime, usage.ru_maxrss / 1024)
sys.exit(status)
"""


def usage_of(command, folder):
    """Runs a program. Returns its output, seconds of processor time, and MB of memory."""
    done = subprocess.run([sys.executable, '-c', MEASURED, *command], cwd=folder, check=True, capture_output=True,
                          text=True)
    output, _, usage = done.stdout.rstrip().rpartition('\n')
    return output, *map(float, usage.split())


def vtk_mesh(samples, spacing, level, windowed_sinc=0, reduction=0.0):
    image = vtk.vtkImageData()
    image.SetDimensions(samples.shape[::-1])
    image.SetSpacing(spacing)
    image.GetPointData().SetScalars(numpy_to_vtk(samples.astype(np.float32).ravel()))
    last = vtk.vtkFlyingEdges3D()
    last.SetInputData(image)
    last.SetValue(0, level)
    last.ComputeNormalsOff()
    if windowed_sinc:
        smoothed = vtk.vtkWindowedSincPolyDataFilter()
        smoothed.SetInputConnection(last.GetOutputPort())
        smoothed.SetNumberOfIterations(windowed_sinc)
        smoothed.SetPassBand(0.01)
        smoothed.NormalizeCoordinatesOn()
        last = smoothed
    if reduction:
        decimated = vtk.vtkQuadricDecimation()
        decimated.SetInputConnection(last.GetOutputPort())
        decimated.SetTargetReduction(reduction)
        last = decimated
    last.Update()
    mesh = last.GetOutput()
    return vtk_to_numpy(mesh.GetPoints().GetData()).astype(float), vtk_to_numpy(
        mesh.GetPolys().GetConnectivityArray()).reshape(-1, 3)


def skimage_mesh(samples, spacing, level):
    vertices, triangles, _, _ = marching_cubes(samples, level, spacing=spacing[::-1], allow_degenerate=False)
    return vertices[:, ::-1].astype(float), triangles


def write_nifti(path, samples, spacing):
    """Writes float samples with voxel (0, 0, 0) at the origin."""
    header = bytearray(352)
    header[0:4] = np.int32(348).tobytes()
    header[40:56] = np.array([3, *samples.shape[::-1], 1, 1, 1, 1], np.int16).tobytes()
    header[70:74] = np.array([16, 32], np.int16).tobytes()  # float32
    header[76:92] = np.array([1, *spacing], np.float32).tobytes()
    header[108:112] = np.float32(352).tobytes()
    header[112:116] = np.float32(1).tobytes()
    header[254:256] = np.int16(1).tobytes()
    header[280:328] = np.hstack([np.diag(spacing), np.zeros((3, 1))]).astype(np.float32).tobytes()
    header[344:348] = b'n+1\0'
    with open(path, 'wb') as file:
        file.write(header + samples.astype('<f4').tobytes())


def others(samples, spacing, level, folder, read_ply):
    """Yields name, vertices, triangles, seconds and MB (or None) of each other program."""

    def timed(make, *options):
        before = time.process_time()
        vertices, triangles = make(samples, spacing, level, *options)
        return vertices, triangles, time.process_time() - before, None

    if vtk:
        yield ('VTK FlyingEdges3D', *timed(vtk_mesh))
        yield ('VTK, windowed sinc', *timed(vtk_mesh, 20))
        yield ('VTK, quadric decimation by 75 %', *timed(vtk_mesh, 0, 0.75))
    if marching_cubes:
        yield ('scikit-image', *timed(skimage_mesh))
    if NII2MESH:
        write_nifti(f'{folder}/nii2mesh.nii', samples, spacing)
        _, seconds, megabytes = usage_of(
            [NII2MESH, 'nii2mesh.nii', '-i', str(level), '-p', '0', '-l', '0', '-r', '0.25', 'nii2mesh.ply'], folder)
        vertices, triangles = read_ply('nii2mesh.ply')
        yield 'nii2mesh -r 0.25', vertices, triangles, seconds, megabytes
