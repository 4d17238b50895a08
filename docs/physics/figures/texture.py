"""Figure 9 of the paper: a flat strip with a bump map, and the force that pretends the bumps."""

import math
import struct
import zlib
from pathlib import Path

import numpy as np

from . import look
from .touch import STEP, along, extruded

LENGTH, RADIUS, DEPTH, STIFFNESS = 60e-3, 2e-3, 2.5e-3, 800
TEXELS, HIGHEST = 2048, 1e-3  # m: white in the picture
PER_UNIT = 0.2e-3  # m: what -bm 1 of a material library stands for


def _profile(x):
    """Height over the strip in m: a dome, a step, a groove, and ripples."""
    dome = 0.9e-3 * np.where(np.abs(x - 9e-3) < 6e-3, np.cos(np.pi * (x - 9e-3) / 12e-3) ** 2, 0)
    step = 0.4e-3 * (np.clip((x - 20e-3) / 4e-3, 0, 1) - np.clip((x - 30e-3) / 1.5e-3, 0, 1))
    groove = -0.25e-3 * np.where(np.abs(x - 26.5e-3) < 1.5e-3, np.cos(np.pi * (x - 26.5e-3) / 3e-3) ** 2, 0)
    ripples = 0.06e-3 * np.where((x > 36e-3) & (x < 54e-3), 1 - np.cos(2 * np.pi * (x - 36e-3) / 2e-3), 0)
    return dome + step + groove + ripples


def _png(values):
    """A grey picture of 16 bits from values between 0 and 1, row by row."""
    rows = (np.round(values * 65535).astype(">u2")).view(np.uint8).reshape(len(values), -1)
    data = zlib.compress(np.insert(rows, 0, 0, axis=1).tobytes())
    header = struct.pack(">IIBBBBB", values.shape[1], values.shape[0], 16, 0, 0, 0, 0)

    def chunk(kind, body):
        return struct.pack(">I", len(body)) + kind + body + struct.pack(">I", zlib.crc32(kind + body))

    return b"\x89PNG\r\n\x1a\n" + chunk(b"IHDR", header) + chunk(b"IDAT", data) + chunk(b"IEND", b"")


def _scene(shop, profile):
    x = (0.5 + np.arange(TEXELS)) / TEXELS * LENGTH
    (shop.folder / "bumps.png").write_bytes(_png(np.tile(profile(x) / HIGHEST, (4, 1))))
    shop.file("material.mtl", f"newmtl felt\nmap_Bump -bm {HIGHEST / PER_UNIT:g} bumps.png\n")
    return shop.file("strip.obj", extruded([(LENGTH, 0), (0, 0)], 40e-3, uv=[1, 0]))


def bumps(shop, path):
    down = RADIUS - DEPTH
    run = shop.touch(_scene(shop, _profile), along([(1e-3, 3e-3), (1e-3, down), (LENGTH - 1e-3, down)], 0.05),
                     proxy_radius=RADIUS, stiffness=STIFFNESS)
    run = run.rows(np.flatnonzero(run.finger[:, 1] < down + 1e-9)[::2])
    figure, (top, bottom) = look.sheet(9.6, 4.6, 2, 1, sharex=True, height_ratios=[1, 1.1])
    x = np.linspace(0, LENGTH, 1000)
    top.fill_between(1e3 * x, 1e3 * _profile(x), -1, color=look.SOLID)
    top.plot(1e3 * x, 1e3 * _profile(x), color=look.SURFACE)
    top.set(ylabel="height, mm", ylim=(-0.25, 1.05), title="a  What the picture says")
    bottom.plot(1e3 * x, -np.gradient(_profile(x), x), color=look.FORCE, linewidth=4, alpha=0.25,
                label="− slope of the profile")
    bottom.plot(1e3 * run.proxy[:, 0], run.force[:, 0] / run.force[:, 1], color=look.FORCE, linewidth=1.2,
                label="felt, at the place of the proxy")
    bottom.axhline(0, color=look.FAINT, linewidth=0.8, zorder=0)
    bottom.set(ylim=(-0.3, 0.45), xlabel="along the strip, mm", ylabel="$f_t / f_n$", title="b  What the hand feels on a flat strip")
    bottom.legend(loc="upper left", bbox_to_anchor=(0.25, 1.0))
    look.save(figure, path)


def _sine(x):
    return 0.25e-3 * (1 + np.sin(2 * np.pi * x / 10e-3))


def _sine_slope(x):
    return 0.05 * np.pi * np.cos(2 * np.pi * x / 10e-3)


def sine(shop, path):
    """A sine of 0.5 mm on 10 mm from a picture, with and without friction, beside its formula."""
    scene, deep, mu = _scene(shop, _sine), RADIUS - 3e-3, 0.3
    figure, axes = look.sheet(9.6, 4.2, 1, 2, sharey=True)
    for axis, speed, letter in zip(axes, (0.05, 0.15), "ab"):
        for friction, colour in ((0, look.FORCE), (mu, look.SLIP)):
            run = shop.touch(scene, along([(1e-3, 3e-3), (1e-3, deep), (LENGTH - 1e-3, deep)], speed), proxy_radius=RADIUS,
                             stiffness=STIFFNESS, static_friction=friction + 0.1 * (friction > 0), dynamic_friction=friction)
            run = run.rows((run.proxy[:, 0] > 25e-3) & (run.proxy[:, 0] < 45e-3))
            x = np.linspace(25e-3, 45e-3, 1000)
            slope = _sine_slope(x)
            axis.plot(1e3 * x, (slope + friction) / (1 - slope * friction), color=colour, linewidth=5, alpha=0.25,
                      label=f"formula, μ = {friction:g}")
            axis.plot(1e3 * run.proxy[:, 0], -run.force[:, 0] / run.force[:, 1], color=colour, linewidth=1.2,
                      label="felt")
        axis.axhline(0, color=look.FAINT, linewidth=0.8, zorder=0)
        axis.set(xlabel="along the strip, mm", title=f"{letter}  {speed:g} m/s", ylim=(-0.25, 0.85))
    axes[0].set(ylabel="force against the stroke, $f_t / f_n$")
    axes[1].legend(loc="upper left", ncols=2)
    look.save(figure, path)


SCENES = Path(__file__).parents[3] / "resources/scenes"


def _smooth(low, high, x):
    t = np.clip((x - low) / (high - low), 0, 1)
    return t * t * (3 - 2 * t)


def _tiles(x):
    """Height in m along the middle of a row of tiles, which begin at 0.3 mm, and dynamic friction."""
    line = np.abs((x - 0.3e-3) - 16e-3 * np.round((x - 0.3e-3) / 16e-3))
    return 0.3e-3 * _smooth(0, 2e-3, line), np.where(line < 1e-3, 0.3, 0.15)


def _coin(x):
    """The same straight over the coin: two petals and the dome."""
    r = np.abs(x) / 44e-3
    flower = 0.8 * _smooth(0, 0.16, 0.68 - r) * _smooth(0.24, 0.34, r)
    bead = 0.5 * (1 - _smooth(0, 0.055, np.abs(r - 0.846)))
    return 1e-3 * np.maximum(np.maximum(flower, 1 - _smooth(0, 0.24, r)), bead), np.full_like(x, 0.2)


def _straight(begin, end, at, speed=0.08):
    """Down at one end, along to the other; `at(x, above)` gives places from the way and the height above."""
    down = np.linspace(3e-3, 0, 60)
    way = np.arange(begin, end, speed * STEP)
    places = np.vstack([at(np.full_like(down, begin), down), at(way, np.zeros_like(way))])
    return np.column_stack([STEP * np.arange(len(places)), places])


def samples(shop, path):
    """Three samples stroked as a finger does; where they have a formula along the stroke it lies below."""
    lean, deep = 0.7, RADIUS / 2 - 1.3e-3  # the samples' proxy has a radius of 1 mm
    row = 1.5 * 56e-3 + 0.6e-3

    def on_wall(x, above):
        height = 0.3e-3 + deep + above
        return np.column_stack([x, row * math.cos(lean) + height * math.sin(lean),
                                height * math.cos(lean) - row * math.sin(lean)])

    def on_leather(x, above):
        bulge = 12e-3 * (1 - (x / 70e-3) ** 6) * (1 - (2.5 / 50) ** 6)
        return np.column_stack([x, bulge + RADIUS / 2 - 2e-3 + above, np.full_like(x, -2.5e-3)])

    def on_coin(x, above):
        return np.column_stack([x, 7e-3 + deep + above, np.zeros_like(x)])

    figure, (top, middle, bottom) = look.sheet(9.6, 6.8, 3, 1)
    wall = shop.touch(SCENES / "texture-wall.glb", _straight(-78e-3, 78e-3, on_wall))
    coin = shop.touch(SCENES / "relief-coin.glb", _straight(-42e-3, 42e-3, on_coin))
    leather = shop.touch(SCENES / "layered-leather.glb", _straight(-62e-3, 62e-3, on_leather))
    out = np.array([0, math.sin(lean), math.cos(lean)])
    for axis, run, normal, height, start, end in ((top, wall, out, _tiles, 0.3e-3, 78e-3),
                                                  (middle, coin, np.array([0, 1, 0]), _coin, -41e-3, 42e-3)):
        x = np.linspace(start, end, 4000)
        relief, friction = height(x)
        slope = np.gradient(relief, x)
        axis.plot(1e3 * x, (slope + friction) / (1 - slope * friction), color=look.FORCE, linewidth=5, alpha=0.25, label="formula")
        run = run.rows(run.force @ normal > 0.2)
        axis.plot(1e3 * run.proxy[:, 0], -run.force[:, 0] / (run.force @ normal), color=look.FORCE, linewidth=1.2, label="felt")
    leather = leather.rows(leather.force[:, 1] > 0.2)
    bottom.plot(1e3 * leather.proxy[:, 0], -leather.force[:, 0] / leather.force[:, 1], color=look.FORCE, linewidth=1.2)
    for axis, title in ((top, "a  Texture wall: bricks, a seam, tiles"), (middle, "b  Coin: a bead, two petals and the dome, a bead"),
                        (bottom, "c  Leather: seam, grain, the worn place, grain, seam; on the slopes of the cushion")):
        axis.axhline(0, color=look.FAINT, linewidth=0.8, zorder=0)
        axis.set(ylabel="$f_t / f_n$", title=title)
    bottom.set(xlabel="along the stroke, mm")
    middle.legend(loc="upper center", ncols=2)
    look.save(figure, path)
