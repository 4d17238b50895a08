"""Cameras of another program's glTF file are where they were when Blender reads what Tactum wrote.

Run with: test_cameras.py TACTUM BLENDER
What would show that this test is wrong: Blender finding no camera in the first file, which is looked at as well.
"""

import base64
import json
import pathlib
import struct
import subprocess
import sys
import tempfile

tactum, blender = sys.argv[1:]
here = pathlib.Path(__file__).parent
positions = struct.pack("<9f", 0, 0, 0, 0.1, 0, 0, 0, 0.1, 0)
strangers = {
    "asset": {"version": "2.0"},
    "scene": 0,
    "scenes": [{"nodes": [0, 1, 3]}],
    "nodes": [
        {"mesh": 0},
        {"name": "rig", "translation": [0.3, 0.2, 0.1], "rotation": [0, 0.3826834, 0, 0.9238795], "children": [2]},
        {"name": "shot", "camera": 0, "translation": [0, 0.1, 0.5], "rotation": [-0.1305262, 0, 0, 0.9914449]},
        {"name": "plan", "camera": 1, "translation": [0, 1, 0], "rotation": [-0.7071068, 0, 0, 0.7071068]},
    ],
    "cameras": [
        {"type": "perspective", "perspective": {"yfov": 0.7, "aspectRatio": 1.5, "znear": 0.01, "zfar": 10}},
        {"type": "orthographic", "orthographic": {"xmag": 0.3, "ymag": 0.2, "znear": 0.01, "zfar": 5}},
    ],
    "meshes": [{"primitives": [{"attributes": {"POSITION": 0}}]}],
    "accessors": [{"bufferView": 0, "componentType": 5126, "count": 3, "type": "VEC3", "min": [0, 0, 0], "max": [0.1, 0.1, 0]}],
    "bufferViews": [{"buffer": 0, "byteLength": 36}],
    "buffers": [{"byteLength": 36, "uri": "data:application/octet-stream;base64," + base64.b64encode(positions).decode()}],
}

with tempfile.TemporaryDirectory() as folder:
    source, written = (pathlib.Path(folder) / name for name in ("strangers.gltf", "written.glb"))
    source.write_text(json.dumps(strangers))
    subprocess.run([tactum, "convert", source, written], check=True, stdout=subprocess.DEVNULL)
    said = subprocess.run(
        [blender, "-b", "--factory-startup", "--python-exit-code", "1", "--python", here / "cameras_in_blender.py", "--",
         source, written],
        check=True, capture_output=True, text=True).stdout
    before, after = (json.loads(line[len("cameras "):]) for line in said.splitlines() if line.startswith("cameras "))
    assert sorted(before) == ["plan", "shot"], f"Blender finds {sorted(before)} in the file itself"
    assert sorted(after) == sorted(before), f"Blender finds {sorted(after)} in what was written"
    for name in before:
        worst = max(abs(a - b) for a, b in zip(before[name], after[name]))
        assert worst < 1e-6, f"{name} is elsewhere, or sees something else, by {worst}: {before[name]} {after[name]}"
print(f"{len(before)} cameras are where they were")
