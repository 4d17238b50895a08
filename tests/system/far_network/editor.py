"""The client at the far end: sends a ball, switches the force on and edits: editor.py TARGET CREDENTIALS EDITS.

Prints a line for each edit: the ns of the monotonic clock when it was asked for, and the revision that it made.
"""
import pathlib
import random
import sys
import time

import numpy as np
import tactum


def ball(radius, rows=24):
    """Its triangles, counter-clockwise from outside."""
    rise, turn = np.meshgrid(np.linspace(-np.pi / 2, np.pi / 2, rows + 1), np.linspace(0, 2 * np.pi, 2 * rows, endpoint=False),
                             indexing="ij")
    positions = radius * np.stack([np.cos(rise) * np.cos(turn), np.sin(rise), np.cos(rise) * np.sin(turn)], -1).reshape(-1, 3)
    at = lambda row, column: row * 2 * rows + column % (2 * rows)
    triangles = []
    for row in range(rows):
        for column in range(2 * rows):
            a, b, c, d = at(row, column), at(row, column + 1), at(row + 1, column + 1), at(row + 1, column)
            triangles += [(a, d, c)] if row == 0 else [(a, c, b)] if row == rows - 1 else [(a, c, b), (a, d, c)]
    return positions, triangles


def main(target, folder, edits):
    folder, choice = pathlib.Path(folder), random.Random(21)
    with tactum.connect(target, name="editor", certificate=folder / "certificate.pem",
                        token=(folder / "token").read_text().strip(), patience=30.0) as haptics:
        made = haptics.add_mesh(*ball(0.02))
        haptics.arm()
        haptics.until(lambda s: s.armed and s.gain == 1, patience=30.0)
        edit = [lambda: haptics.material(stiffness=choice.uniform(200, 600)),
                lambda: haptics.material(static_friction=choice.uniform(0.3, 0.8), dynamic_friction=choice.uniform(0, 0.3)),
                lambda: haptics.material(damping=choice.uniform(0, 1), viscosity=choice.uniform(0, 2)),
                lambda: haptics.material(shading=choice.random() < 0.5),
                lambda: haptics.move(made, position=[choice.uniform(-1e-3, 1e-3) for _ in range(3)])]
        for _ in range(edits):
            time.sleep(choice.uniform(0, 0.1))
            asked = time.monotonic_ns()
            print(asked, choice.choice(edit)().revision, flush=True)


main(sys.argv[1], sys.argv[2], int(sys.argv[3]))
