"""Inside Blender: what it finds in glTF files, a line of JSON for each, as tests/app/three/list_scene.mjs says it of three.js.

Run with: blender -b --factory-startup --python-exit-code 1 --python list_scene.py -- FILE...
Blender has z up; what is told has y up, as glTF has.
"""

import json
import sys

import bpy
import mathutils
import numpy

if "bool" not in vars(numpy):  # Debian 12 has a numpy newer than its Blender's glTF reader
    numpy.bool = bool

Y_UP = mathutils.Matrix(((1, 0, 0, 0), (0, 0, 1, 0), (0, -1, 0, 0), (0, 0, 0, 1)))


def material_told(material):
    inputs = next(node for node in material.node_tree.nodes if node.type == "BSDF_PRINCIPLED").inputs
    return {
        "name": material.name,
        "colour": list(inputs["Base Color"].default_value)[:3],
        "roughness": inputs["Roughness"].default_value,
        "metallic": inputs["Metallic"].default_value,
        "bumps": inputs["Normal"].is_linked,
    }


def told(thing):
    points = [Y_UP @ thing.matrix_world @ vertex.co for vertex in thing.data.vertices]
    return {
        "name": thing.name,
        "matrix": [number for row in Y_UP @ thing.matrix_world @ Y_UP.inverted() for number in row],
        "box": [extreme(point[axis] for point in points) for extreme in (min, max) for axis in range(3)],
        "materials": [material_told(material) for material in thing.data.materials],
    }


for source in sys.argv[sys.argv.index("--") + 1:]:
    bpy.ops.wm.read_homefile(use_empty=True)
    bpy.ops.import_scene.gltf(filepath=source)
    objects = [told(thing) for thing in bpy.data.objects if thing.type == "MESH"]
    print(json.dumps({"reader": f"Blender {bpy.app.version_string}", "objects": objects}))
