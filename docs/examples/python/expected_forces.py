"""Plays the stroke of a bundle and compares: python3 expected_forces.py BUNDLE.zip TEAPOT.glb"""
import sys
import zipfile

import numpy as np
import tactum

bundle = zipfile.ZipFile(sys.argv[1])
path, expected = (np.loadtxt(bundle.open(name), delimiter=",", skiprows=1) for name in ("finger.csv", "forces.csv"))
with tactum.serve() as haptics:
    haptics.open(sys.argv[2])
    haptics.material(static_friction=0)  # as if the teapot were wet
    wet = haptics.replay(path).force
    haptics.material(static_friction=0.2, dynamic_friction=0.15)
    haptics.material(object=1, surface=3, static_friction=0.6, dynamic_friction=0.5)  # its handle
    haptics.material(object=2, static_friction=0.4, dynamic_friction=0.3)  # the table
    felt = haptics.replay(path).force
print(f"wet: {np.abs(wet - expected[:, -3:]).max():.3g} N from what is expected")
print(f"dry: {np.abs(felt - expected[:, -3:]).max():.3g} N")
sys.exit(0 if np.abs(felt - expected[:, -3:]).max() <= 1e-12 else 1)
