"""Figure 9 of the paper: a flat strip with a bump map, and the force that pretends the bumps."""

import struct
import zlib

import numpy as np

from . import look
from .touch import along, extruded

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
