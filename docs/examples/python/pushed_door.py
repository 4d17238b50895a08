"""A door with detents, pushed open by a finger: its angle and the force over time. python3 pushed_door.py [PLOT.png]"""
import sys

import numpy as np
import tactum
from strokes import saved

WIDTH, HEIGHT, THICK = 0.10, 0.15, 0.006  # m
SPACING, DETENT = 0.4, 0.03  # rad, N m
ARM = 0.08  # m from the hinge to where the finger pushes

corners = np.array([[x, y, z] for x in (0, WIDTH) for y in (0, HEIGHT) for z in (0, THICK)])
sides = [[0, 1, 3], [0, 3, 2], [4, 6, 7], [4, 7, 5], [0, 4, 5], [0, 5, 1], [2, 3, 7], [2, 7, 6], [0, 2, 6], [0, 6, 4], [1, 5, 7],
         [1, 7, 3]]
scene = tactum.Scene()
door = scene.add_mesh(corners, sides, name="door")
body = door.make_body()
body.mass = 0.09
body.add_joint("hinge", at=(0, 0, THICK), axis=(0, -1, 0), low=0, high=1.4, spacing=SPACING, detent=DETENT, damping=0.01)
scene.set(damping=2)  # N s/m, of the surface

times = np.arange(0, 2.5, 1e-3)
push = np.interp(times, [0, 0.1, 1.9, 2.0], [-0.002, 0, 0.06, -0.01])  # m: into the door, and away again
world = tactum.World(scene)
angles, forces = [], []
for z in push:
    step = world.step((ARM, HEIGHT / 2, z))
    angles.append(world.reading(body).value)
    forces.append(np.linalg.norm(step.force))
angles, forces = np.array(angles), np.array(forces)
print(f"{forces.max():.3f} N open it, {DETENT / ARM:.3f} N at the arm of its detents; "
      f"it rests at {angles[-1] / SPACING:.3f} of them")

with saved() as plot:
    plot.plot(times, forces, color="tab:green")
    plot.set_xlabel("time (s)")
    plot.set_ylabel("force on the finger (N)", color="tab:green")
    opened = plot.twinx()
    opened.plot(times, np.degrees(angles), color="tab:blue")
    for detent in range(4):
        opened.axhline(np.degrees(detent * SPACING), linestyle=":", color="grey", linewidth=0.8)
    opened.set_ylabel("angle of the door (degrees), detents dotted", color="tab:blue")

sys.exit(0 if abs(angles[-1] / SPACING - 2) < 1e-2 and 0.3 < forces.max() < 0.6 else 1)
