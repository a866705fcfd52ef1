"""Run by Blender: imports a mesh and exports what it has of it as binary STL.

usage: blender --background --python blender_reader.py -- MESH OUTPUT.stl
"""
import os
import sys

import bpy
import numpy

numpy.bool = bool  # what the importer of glTF wants, and newer releases of NumPy lack

source, output = sys.argv[sys.argv.index("--") + 1:]
bpy.ops.wm.read_factory_settings(use_empty=True)
upright = {"axis_forward": "Y", "axis_up": "Z"}
{
    ".stl": lambda: bpy.ops.import_mesh.stl(filepath=source),
    ".ply": lambda: bpy.ops.import_mesh.ply(filepath=source),
    ".obj": lambda: bpy.ops.import_scene.obj(filepath=source, **upright),
    ".glb": lambda: bpy.ops.import_scene.gltf(filepath=source),
}[os.path.splitext(source)[1]]()
bpy.ops.export_mesh.stl(filepath=output, ascii=False)
