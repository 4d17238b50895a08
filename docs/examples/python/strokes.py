"""What the examples share: a plate, strokes over it, and their plots."""
import contextlib
import sys

import numpy as np
import tactum


def add_plate(to, half=0.1):
    """A square in z = 0, for a scene here or a server's."""
    corners = half * np.array([[-1, -1, 0], [1, -1, 0], [1, 1, 0], [-1, 1, 0]], dtype=float)
    return to.add_mesh(corners, [[0, 1, 2], [0, 2, 3]], name="plate")


def plate_scene():
    """A scene with nothing but the plate."""
    scene = tactum.Scene()
    add_plate(scene)
    return scene


@contextlib.contextmanager
def saved():
    """The axes of a plot, which goes to the file that the command line names first; nowhere without one."""
    import matplotlib

    matplotlib.use("Agg")
    import matplotlib.pyplot as plt

    figure, axes = plt.subplots(figsize=(7, 4.5), layout="constrained")
    yield axes
    if len(sys.argv) > 1:
        figure.savefig(sys.argv[1], dpi=120)


def press_and_slide(depth=1e-3, way=0.05, speed=0.05, radius=1e-3, rate=1000):
    """Down into the plate within 0.2 s, then along x: rows of t, x, y, z."""
    down = np.linspace(5e-3, radius - depth, rate // 5)
    along = np.arange(0, way, speed / rate)
    x = np.concatenate([np.zeros_like(down), along]) - way / 2
    z = np.concatenate([down, np.full_like(along, radius - depth)])
    return np.column_stack([np.arange(len(x)) / rate, x, np.full_like(x, 0.003), z])
