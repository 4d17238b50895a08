"""A sample feels as its bundle says: python3 felt_as_expected.py SAMPLE.glb BUNDLE.tactum"""
import sys
import zipfile

import numpy as np
import tactum

sample, bundle = sys.argv[1:]
expected = np.loadtxt(zipfile.ZipFile(bundle).open("forces.csv"), delimiter=",", skiprows=1)[:, -3:]
touch = tactum.open(sample).touch()
difference = np.abs(touch.force - expected).max()
if not (difference <= 1e-12 and np.abs(expected).max() > 0.01):
    sys.exit(f"{difference} N from what is expected")
print(f"{len(touch.t)} steps as expected, {difference} N apart")
