"""Programs that open meshes. Each function reads a file as its program does and returns figures, in the
units of the format: metres of GLB."""
import os
import re
import subprocess
import sys
import tempfile

import numpy

from figures import figures, figures_of_off, figures_of_stl

HERE = os.path.dirname(os.path.abspath(__file__))


def run(*command):
    """The output of a program."""
    done = subprocess.run(command, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True,
                          errors="replace", timeout=600)
    if done.returncode != 0:
        last = done.stdout.strip().splitlines()[-1:] or [""]
        raise RuntimeError(f"exit code {done.returncode}: {last[0]}")
    return done.stdout


def number_after(text, name):
    return float(re.search(re.escape(name) + r"\s*[:=]\s*([-\d.e+]+)", text).group(1))


def vtk(file):
    import vtk as library
    from vtk.util.numpy_support import vtk_to_numpy
    readers = {".stl": library.vtkSTLReader, ".ply": library.vtkPLYReader,
               ".obj": library.vtkOBJReader, ".vtp": library.vtkXMLPolyDataReader,
               ".glb": library.vtkGLTFReader}
    reader = readers[os.path.splitext(file)[1]]()
    reader.SetFileName(file)
    if file.endswith(".glb"):
        reader.ApplyDeformationsToGeometryOn()  # the transforms of nodes
        parts = library.vtkCompositeDataGeometryFilter()
        parts.SetInputConnection(reader.GetOutputPort())
        reader = parts
    reader.Update()
    mesh = reader.GetOutput()
    cells = vtk_to_numpy(mesh.GetPolys().GetConnectivityArray())
    assert len(cells) == 3 * mesh.GetNumberOfCells(), "cells that are no triangles"
    return figures(vtk_to_numpy(mesh.GetPoints().GetData()), cells)


def assimp(file):
    with tempfile.TemporaryDirectory() as folder:
        run("assimp", "export", file, f"{folder}/mesh.stl", "-fstlb")
        return figures_of_stl(f"{folder}/mesh.stl")


def open3d(file):
    import open3d as library
    mesh = library.io.read_triangle_mesh(file)
    unit = 0.001 if file.endswith(".glb") else 1  # it ignores the transforms of nodes
    return figures(unit * numpy.asarray(mesh.vertices), mesh.triangles)


def three(file):
    with tempfile.TemporaryDirectory() as folder:
        run("node", f"{os.environ['THREE']}/three_reader.mjs", file, f"{folder}/mesh.stl")
        return figures_of_stl(f"{folder}/mesh.stl")


def gltf_validator(file):
    """Khronos' validator. It counts triangles, and ignores their positions."""
    told = run("node", f"{os.environ['THREE']}/validate.mjs", file)
    return {"triangles": int(number_after(told, "triangles")), "closed": None, "volume": None}


def blender(file):
    with tempfile.TemporaryDirectory() as folder:
        run("blender", "--background", "--factory-startup", "--python-exit-code", "1", "--python",
            f"{HERE}/blender_reader.py", "--", file, f"{folder}/mesh.stl")
        return figures_of_stl(f"{folder}/mesh.stl")


def meshlab(file):
    with tempfile.TemporaryDirectory() as folder:
        run("xvfb-run", "-a", "meshlabserver", "-i", file, "-o", f"{folder}/mesh.off")
        return figures_of_off(f"{folder}/mesh.off")


def openscad(file):
    with tempfile.TemporaryDirectory() as folder:
        with open(f"{folder}/import.scad", "w") as program:
            program.write(f'import("{os.path.abspath(file)}");')
        run("openscad", "-o", f"{folder}/mesh.off", f"{folder}/import.scad")
        return figures_of_off(f"{folder}/mesh.off")


def prusa_slicer(file):
    # One paragraph per object.
    told = [part for part in run("prusa-slicer", "--info", file).split("[") if "volume" in part]
    return {"triangles": int(sum(number_after(part, "number_of_facets") for part in told)),
            "closed": all("manifold = yes" in part for part in told),
            "volume": sum(number_after(part, "volume") for part in told)}


def admesh(file):
    told = run("admesh", "-e", file)
    open_before = re.search(r"Total disconnected facets\s*:\s*(\d+)", told).group(1)
    return {"triangles": int(number_after(told, "Number of facets")), "closed": open_before == "0",
            "volume": number_after(told, "Volume")}


# The programs, with the formats that they read. MeshLab 2020.09 of Debian fails an assertion for every OBJ file,
# including those of other programs.
PROGRAMS = {
    "VTK": (vtk, ["stl", "ply", "obj", "glb", "vtp"]),
    "assimp": (assimp, ["stl", "ply", "obj", "glb", "3mf"]),
    "Open3D": (open3d, ["stl", "ply", "obj", "glb"]),
    "three.js": (three, ["stl", "ply", "obj", "glb", "3mf", "vtp"]),
    "glTF-Validator": (gltf_validator, ["glb"]),
    "Blender": (blender, ["stl", "ply", "obj", "glb"]),
    "MeshLab": (meshlab, ["stl", "ply"]),
    "OpenSCAD": (openscad, ["stl", "3mf"]),
    "PrusaSlicer": (prusa_slicer, ["stl", "obj", "3mf"]),
    "admesh": (admesh, ["stl"]),
}

if __name__ == "__main__":
    import json
    print("figures", json.dumps(PROGRAMS[sys.argv[1]][0](sys.argv[2])))
