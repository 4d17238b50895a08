"""Inside Blender: what cameras it finds in each file, as a line of JSON. Run by test_cameras.py."""

import json
import sys

import bpy
import numpy

if "bool" not in vars(numpy):  # Debian 12 has a numpy newer than its Blender's glTF reader
    numpy.bool = bool

for source in sys.argv[sys.argv.index("--") + 1:]:
    bpy.ops.wm.read_homefile(use_empty=True)
    bpy.ops.import_scene.gltf(filepath=source)
    cameras = {
        thing.name: [number for row in thing.matrix_world for number in row]
        + [thing.data.type == "ORTHO", thing.data.angle, thing.data.ortho_scale, thing.data.clip_start, thing.data.clip_end]
        for thing in bpy.data.objects if thing.type == "CAMERA"
    }
    print("cameras", json.dumps(cameras))
