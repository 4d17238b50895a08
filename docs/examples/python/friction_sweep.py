"""What a coefficient of friction does to a stroke, for many of them: python3 friction_sweep.py [PLOT.png]"""
import sys

import numpy as np
import tactum
from strokes import plate_scene, press_and_slide, saved

coefficients = np.linspace(0, 1, 11)
path = press_and_slide()
scene = plate_scene()
touch = scene.sweep("dynamic_friction", coefficients, path)  # static friction goes along
sliding = touch.force[:, -200:]
ratios = -sliding[..., 0].mean(axis=1) / sliding[..., 2].mean(axis=1)
for coefficient, ratio in zip(coefficients, ratios):
    print(f"{coefficient:4.1f} asked for, {ratio:.6f} felt")

with saved() as plot:
    for coefficient, force in zip(coefficients, touch.force):
        plot.plot(path[:, 0], -force[:, 0], label=f"{coefficient:.1f}")
    plot.set_xlabel("time (s)")
    plot.set_ylabel("force against the stroke (N)")
    plot.legend(title="friction", ncol=2)

sys.exit(0 if np.allclose(ratios, coefficients, atol=1e-6) else 1)
