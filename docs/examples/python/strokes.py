"""What the examples share: a plate, and strokes over it."""
import numpy as np


def add_plate(haptics, half=0.1):
    """A square in z = 0 that is felt from above; the number of its object."""
    corners = half * np.array([[-1, -1, 0], [1, -1, 0], [1, 1, 0], [-1, 1, 0]], dtype=float)
    return haptics.add_mesh(corners, [[0, 1, 2], [0, 2, 3]], name="plate")


def press_and_slide(depth=1e-3, way=0.05, speed=0.05, radius=1e-3, rate=1000):
    """Down into the plate within 0.2 s, then along x: rows of t, x, y, z."""
    down = np.linspace(5e-3, radius - depth, rate // 5)
    along = np.arange(0, way, speed / rate)
    x = np.concatenate([np.zeros_like(down), along]) - way / 2
    z = np.concatenate([down, np.full_like(along, radius - depth)])
    return np.column_stack([np.arange(len(x)) / rate, x, np.full_like(x, 0.003), z])
