"""Which stiffness gives 2 N where the finger is 3 mm deep? python3 find_stiffness.py [PLOT.png]"""
import sys

import numpy as np
from strokes import plate_scene, press_and_slide, saved

WANTED, DEPTH = 2.0, 3e-3  # N, m

scene = plate_scene()
path = press_and_slide(depth=DEPTH)
low, high, tried = 1.0, 10000.0, []
while high - low > 1e-6:
    middle = (low + high) / 2
    scene.set(stiffness=middle)
    felt = scene.touch(path).force[:, 2].max()
    tried.append((middle, felt))
    low, high = (middle, high) if felt < WANTED else (low, middle)
print(f"{middle:.4f} N/m give {felt:.6f} N, after {len(tried)} strokes")

with saved() as plot:
    tried = np.array(tried)
    plot.loglog(tried[:, 0], tried[:, 1], "o-")
    plot.axhline(WANTED, linestyle="--", color="grey")
    plot.set_xlabel("stiffness (N/m)")
    plot.set_ylabel("largest force of the stroke (N)")

sys.exit(0 if abs(middle - WANTED / DEPTH) < 1e-3 else 1)
