"""Exports a bundle, then runs the script of the docs over it: SCRIPT SCENES."""
import os
import pathlib
import subprocess
import sys
import tempfile

script, scenes = sys.argv[1], pathlib.Path(sys.argv[2])
with tempfile.TemporaryDirectory() as folder:
    bundle = pathlib.Path(folder) / "teapot.zip"
    subprocess.run([os.environ["TACTUM"], "convert", scenes / "teapot.glb", bundle, "--path",
                    scenes / "teapot-finger.csv"], check=True)
    subprocess.run([sys.executable, script, bundle, scenes / "teapot.glb"], check=True)
assert len(pathlib.Path(script).read_text().splitlines()) <= 20
