"""A plate that rises under a resting finger and then goes to and fro, as a glTF animation."""

import base64
import json

import numpy as np

from . import look
from .friction import slip_of, stick_and_slip
from .touch import STEP

RADIUS, STATIC, DYNAMIC = 1e-3, 0.8, 0.5
LOW, HIGH, SPEED = -4e-3, 3e-3, 0.035  # m, m, m/s: on its way up
SWING, RISEN, END = 7e-3, 0.2, 1.8  # m, s, s


def _place(t):
    """Of the plate's surface, x and y in m."""
    x = np.where(t > RISEN + 0.1, SWING * np.sin(2 * np.pi * (t - RISEN - 0.1) / 0.75), 0)
    return np.column_stack([x, np.minimum(LOW + SPEED * t, HIGH), np.zeros_like(t)])


def _gltf(times, places, half=0.1):
    """A square sheet with an animated translation."""
    corners = [[-half, 0, -half], [-half, 0, half], [half, 0, half], [half, 0, -half]]
    arrays = [np.array(corners, "<f4"), np.array([0, 1, 2, 0, 2, 3], "<u2"), times.astype("<f4"),
              places.astype("<f4")]
    data, views = b"", []
    for array in arrays:
        views.append({"buffer": 0, "byteOffset": len(data), "byteLength": array.nbytes})
        data += array.tobytes()
    bounds = [{"min": [-half, 0, -half], "max": [half, 0, half]}, {},
              {"min": [float(times[0])], "max": [float(times[-1])]}, {}]
    kinds = [(5126, "VEC3"), (5123, "SCALAR"), (5126, "SCALAR"), (5126, "VEC3")]
    accessors = [{"bufferView": i, "componentType": number, "type": kind, "count": arrays[i].size // (3 if kind ==
                  "VEC3" else 1), **bounds[i]} for i, (number, kind) in enumerate(kinds)]
    return json.dumps({
        "asset": {"version": "2.0"}, "scene": 0, "scenes": [{"nodes": [0]}], "nodes": [{"mesh": 0}],
        "meshes": [{"primitives": [{"attributes": {"POSITION": 0}, "indices": 1}]}],
        "animations": [{"channels": [{"sampler": 0, "target": {"node": 0, "path": "translation"}}],
                        "samplers": [{"input": 2, "output": 3}]}],
        "buffers": [{"byteLength": len(data),
                     "uri": "data:application/octet-stream;base64," + base64.b64encode(data).decode()}],
        "bufferViews": views, "accessors": accessors})


def plate(shop, path):
    keys = np.arange(0, END + 0.1, 5e-3)
    t = np.arange(2 * STEP, END, 2 * STEP)
    finger = np.column_stack([t, np.zeros((len(t), 3))])
    run = shop.touch(shop.file("plate.gltf", _gltf(keys, _place(keys))), finger, proxy_radius=RADIUS,
                     stiffness=800, static_friction=STATIC, dynamic_friction=DYNAMIC)
    surface = np.column_stack([np.interp(t, keys, _place(keys)[:, i]) for i in range(3)])
    figure, axes = look.sheet(9.6, 5.2, 3, 1, sharex=True, height_ratios=[1, 1.2, 1])
    up, aside, ratio = axes
    for which, panel, name in ((1, up, "height"), (0, aside, "sideways")):
        panel.plot(t, 1e3 * surface[:, which], color=look.SURFACE, label="plate")
        panel.plot(t, 1e3 * run.proxy[:, which], color=look.PROXY, label="proxy")
        panel.plot(t, 1e3 * run.finger[:, which], color=look.FINGER, label="finger")
        panel.set(ylabel=f"{name}, mm")
    up.fill_between(t, 1e3 * surface[:, 1], 1e3 * LOW, color=look.SOLID)
    up.set_title("a  It pushes the proxy up, off the finger")
    up.legend(loc="lower right", ncols=3)
    aside.set_title("b  It takes the proxy along until the spring pulls too hard")
    slips = slip_of(run.proxy - surface, 1e-7)  # the file's times are single precision
    ratio.set(xlabel="time, s", ylabel="$f_t / f_n$", title="c  Friction, relative to the plate")
    for value in (STATIC, DYNAMIC, -DYNAMIC, -STATIC):
        ratio.axhline(value, color=look.FAINT, linewidth=0.8, zorder=0)
    touching = run.force[:, 1] > 1e-6
    force = np.where(touching, run.force[:, 0] / np.where(touching, run.force[:, 1], 1), np.nan)
    stick_and_slip(ratio, t, force, slips)
    ratio.legend(loc="lower left", ncols=2)
    look.save(figure, path)
