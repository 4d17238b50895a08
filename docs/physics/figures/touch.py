"""Scenes and finger paths as files, and what `tactum touch` makes of them."""

import csv
import subprocess
from pathlib import Path

import numpy as np

STEP = 1e-3  # s: the paths have a row a millisecond where nothing else is said


class Touch:
    """The columns of a replay: t in s, finger, proxy (rows of x, y, z in m) and force in N."""

    def __init__(self, table):
        self.t = table[:, 0]
        self.finger, self.proxy, self.force = table[:, 1:4], table[:, 4:7], table[:, 7:10]

    def rows(self, which):
        return Touch(np.column_stack([self.t, self.finger, self.proxy, self.force])[which])


class Workshop:
    """A folder for what the figures need, and the programs that work on it."""

    def __init__(self, folder, tactum, list_spheres):
        self.folder, self.tactum, self.list_spheres = Path(folder), tactum, list_spheres

    def file(self, name, text):
        path = self.folder / name
        path.write_text(text)
        return path

    def touch(self, scene, path, **options):
        """Replays the rows (t, x, y, z) over a scene. An option a_b=1 is passed as --a-b 1."""
        fingers, out = self.folder / "finger.csv", self.folder / "touch.csv"
        np.savetxt(fingers, path, delimiter=",", header="t,x,y,z", comments="", fmt="%.17g")
        words = [w for name, value in options.items() for w in ("--" + name.replace("_", "-"), str(value))]
        self._run(self.tactum, "touch", scene, "--path", fingers, "--out", out, *words)
        return Touch(np.loadtxt(out, delimiter=",", skiprows=1))

    def spheres(self, scene):
        """Every sphere of the scene's hierarchy as a dictionary of numbers."""
        lines = self._run(self.list_spheres, scene).splitlines()
        return [{key: float(value) for key, value in row.items()} for row in csv.DictReader(lines)]

    @staticmethod
    def _run(*words):
        return subprocess.run([str(w) for w in words], check=True, stdout=subprocess.PIPE, text=True).stdout


def extruded(outline, width, normals=None, uv=None):
    """OBJ text: a line of points (x, y) drawn out along z, with a normal and a texture u for each where given."""
    outline = np.asarray(outline, float)
    lines = ["mtllib material.mtl", "usemtl felt"] if uv is not None else []
    for x, y in outline:
        lines += [f"v {x:.9g} {y:.9g} {-width / 2:.9g}", f"v {x:.9g} {y:.9g} {width / 2:.9g}"]
    for x, y in normals if normals is not None else []:
        lines += [f"vn {x:.9g} {y:.9g} 0"] * 2
    for u in uv if uv is not None else []:
        lines += [f"vt {u:.9g} 0", f"vt {u:.9g} 1"]
    for i in range(len(outline) - 1):
        lines.append("f " + " ".join(_corner(2 * i + k + 1, uv, normals) for k in (0, 1, 3, 2)))
    return "\n".join(lines) + "\n"


def _corner(index, uv, normals):
    if uv is None and normals is None:
        return str(index)
    return f"{index}/{index if uv is not None else ''}" + (f"/{index}" if normals is not None else "")


def prism(sides, radius, width, smooth=False):
    """OBJ text of a prism around z; smooth: with the normals of the cylinder around it."""
    turn = 2 * np.pi * np.arange(sides + 1) / sides
    outward = np.column_stack([np.cos(turn), np.sin(turn)])
    return extruded(radius * outward, width, outward if smooth else None)


def along(points, speed, step=STEP, start=0.0):
    """Rows (t, x, y, z) along straight lines between points (x, y) at a speed in m/s."""
    points = np.asarray(points, float)
    lengths = np.linalg.norm(np.diff(points, axis=0), axis=1)
    reached = np.concatenate([[0], np.cumsum(lengths)]) / speed
    t = np.arange(0, reached[-1] + step / 2, step)
    x, y = (np.interp(t, reached, points[:, i]) for i in (0, 1))
    return np.column_stack([start + t, x, y, np.zeros_like(t)])


def circle(outside, inside, speed, turns=1.0):
    """Rows from outside to a circle of a radius about z, and around it counter-clockwise."""
    approach = along([[outside, 0], [inside, 0]], speed)
    angle = np.arange(0, 2 * np.pi * turns, speed * STEP / inside)
    t = approach[-1, 0] + STEP * (1 + np.arange(len(angle)))
    around = np.column_stack([t, inside * np.cos(angle), inside * np.sin(angle), np.zeros_like(t)])
    return np.vstack([approach, around])
