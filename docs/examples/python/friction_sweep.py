"""What a coefficient of friction does to a stroke, for many of them: python3 friction_sweep.py [PLOT.png]"""
import sys

import numpy as np
import tactum
from strokes import add_plate, press_and_slide

path = press_and_slide()
coefficients = np.linspace(0, 1, 11)
ratios, strokes = [], []
with tactum.serve() as haptics:
    add_plate(haptics)
    for coefficient in coefficients:
        haptics.material(static_friction=coefficient, dynamic_friction=coefficient)
        force = haptics.replay(path).force
        strokes.append(-force[:, 0])
        sliding = force[-200:]
        ratios.append(-sliding[:, 0].mean() / sliding[:, 2].mean())
        print(f"{coefficient:4.1f} asked for, {ratios[-1]:.6f} felt")

if len(sys.argv) > 1:
    import matplotlib

    matplotlib.use("Agg")
    import matplotlib.pyplot as plt

    for coefficient, stroke in zip(coefficients, strokes):
        plt.plot(path[:, 0], stroke, label=f"{coefficient:.1f}")
    plt.xlabel("time (s)")
    plt.ylabel("force against the stroke (N)")
    plt.legend(title="friction", ncol=2)
    plt.savefig(sys.argv[1], dpi=120)

sys.exit(0 if np.allclose(ratios, coefficients, atol=1e-6) else 1)
