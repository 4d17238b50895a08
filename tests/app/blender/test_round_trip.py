"""A scene goes through Blender and back: every value that a surface has is there again.

Run with: test_round_trip.py TACTUM BLENDER SCENES ADDON_FOLDER
"""

import json
import pathlib
import subprocess
import sys
import tempfile

tactum, blender, scenes, addon = sys.argv[1:]
here = pathlib.Path(__file__).parent


def told(scene):
    return json.loads(subprocess.run([tactum, "info", "--json", scene], check=True, capture_output=True).stdout)


def feel(info):
    """Of each surface, by the names of object and surface."""
    keys = ("parameters", "sides", "shading", "visible", "locked")
    return {
        (thing["name"], surface["name"]): {key: surface[key] for key in keys}
        for thing in info["objects"]
        for surface in thing["surfaces"]
    }


def layers(info):
    return sum(len(surface["layers"]) for thing in info["objects"] for surface in thing["surfaces"])


compared = 0
with tempfile.TemporaryDirectory() as folder:
    for name in ("teapot", "friction-ladder", "viscosity-ladder", "stiffness-ladder", "texture-wall"):
        for how, extras in ((addon, "none"), ("none", "extras")):
            source, out = pathlib.Path(scenes) / f"{name}.glb", pathlib.Path(folder) / f"{name}-{extras}.glb"
            subprocess.run(
                [blender, "-b", "--factory-startup", "--python-exit-code", "1", "--python",
                 here / "through_blender.py", "--", source, out, how, extras],
                check=True, stdout=subprocess.DEVNULL)  # what it says of a fault goes to standard error
            before, after = told(source), told(out)
            assert feel(before) == feel(after), f"{name}, {extras}: {feel(before)}\n{feel(after)}"
            assert layers(before) == layers(after), f"{name}: layers are lost"
            assert before["parameters"] == after["parameters"], f"{name}: {after['parameters']}"
            said = " ".join(finding["sentence"] for finding in after["findings"])
            assert "comes from extras" in said, said
            compared += len(feel(before))
print(f"{compared} surfaces feel as before")
