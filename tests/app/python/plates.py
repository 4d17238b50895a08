"""What the tests of the compiled module share: a plate in z = 0 whose forces are known in closed form, and boxes."""
import os
import subprocess

import numpy as np
import tactum

CORNERS = 0.1 * np.array([[-1, -1, 0], [1, -1, 0], [1, 1, 0], [-1, 1, 0]], dtype=float)
TRIANGLES = [[0, 1, 2], [0, 2, 3]]


def plate(**feel):
    """A scene of one plate, felt from both sides."""
    scene = tactum.Scene()
    scene.add_mesh(CORNERS, TRIANGLES, name="plate")
    scene.set(**feel)
    return scene


def box(low, high):
    """Corners and triangles of a box along the axes."""
    corners = np.array([[x, y, z] for x in (0, 1) for y in (0, 1) for z in (0, 1)], dtype=float)
    sides = [[0, 1, 3], [0, 3, 2], [4, 6, 7], [4, 7, 5], [0, 4, 5], [0, 5, 1], [2, 3, 7], [2, 7, 6], [0, 2, 6], [0, 6, 4],
             [1, 5, 7], [1, 7, 3]]
    return np.array(low) + corners * (np.array(high, dtype=float) - low), sides


def slide(scene, depth=1e-3, way=0.03, rate=1000):
    """Rows of t, x, y, z: down into the plate within 0.2 s, then along x at 0.05 m/s."""
    down = np.linspace(5e-3, scene.proxy_radius - depth, rate // 5)
    along = np.arange(0, way, 0.05 / rate)
    x = np.concatenate([np.zeros_like(down), along])
    z = np.concatenate([down, np.full_like(along, down[-1])])
    return np.column_stack([np.arange(len(x)) / rate, x, np.full_like(x, 0.003), z])


def by_the_program(scene_file, path, folder, *options):
    """The columns of `tactum touch`."""
    finger, out = folder / "finger.csv", folder / "touch.csv"
    np.savetxt(finger, path, delimiter=",", header="t,x,y,z", comments="", fmt="%.17g")
    subprocess.run([os.environ["TACTUM"], "touch", scene_file, "--path", finger, "--out", out, *options], check=True,
                   stdout=subprocess.DEVNULL)
    return np.loadtxt(out, delimiter=",", skiprows=1)
