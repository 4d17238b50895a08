"""Inside Blender: reads a glb, and writes it again. Run by test_round_trip.py."""

import sys

import addon_utils
import bpy
import numpy

if "bool" not in vars(numpy):  # Debian 12 has a numpy newer than its Blender's glTF reader
    numpy.bool = bool

source, target, addon_folder, export_extras = sys.argv[sys.argv.index("--") + 1:]
bpy.ops.wm.read_homefile(use_empty=True)
if addon_folder != "none":
    sys.path.insert(0, addon_folder)
    assert addon_utils.enable("tactum_haptics", default_set=True), "the add-on cannot be enabled"
bpy.ops.import_scene.gltf(filepath=source)
if addon_folder != "none":
    bpy.context.view_layer.objects.active = next(o for o in bpy.data.objects if o.type == "MESH")
    fresh = bpy.data.materials.new("fresh")
    with bpy.context.temp_override(material=fresh):
        bpy.ops.material.tactum_add_feel()
    assert fresh["tactum_stiffness"] == 800, "a new material has no feel"
bpy.ops.export_scene.gltf(filepath=target, export_format="GLB", export_extras=export_extras == "extras")
