"""Figures 5 and 6 of the paper: around a ten-sided prism without and with shading, and around a cylinder."""

import numpy as np

from . import look
from .touch import circle, extruded
from .touch import prism as prism_mesh

SIDES, RADIUS, FINGER, PROXY = 10, 50e-3, 44e-3, 2e-3
ROUND = 720  # sides of what stands for a true cylinder


def _around(shop, sides, shading):
    smooth = shading == "on"
    scene = shop.file(f"prism{sides}{shading}.obj", prism_mesh(sides, RADIUS, 60e-3, smooth))
    path = circle(60e-3, FINGER, 0.1)
    run = shop.touch(scene, path, proxy_radius=PROXY, stiffness=500, shading=shading)
    return run.rows(path[:, 1] ** 2 + path[:, 2] ** 2 < (FINGER + 1e-9) ** 2)


def _outline(sides, radius):
    turn = 2 * np.pi * np.arange(sides + 1) / sides
    return 1e3 * radius * np.column_stack([np.cos(turn), np.sin(turn)])


def _plan(axes, run, sides, title):
    look.picture(axes, title)
    axes.fill(*_outline(min(sides, 180), RADIUS).T, facecolor=look.SOLID, edgecolor=look.SURFACE, linewidth=1.2)
    finger, proxy = 1e3 * run.finger[:, :2], 1e3 * run.proxy[:, :2]
    axes.plot(*finger[::20].T, color=look.FINGER, linewidth=1)
    axes.plot(*proxy[::20].T, color=look.PROXY, linewidth=1)
    some = np.linspace(0, len(finger) - 1, 71).astype(int)[:-1]
    way = 1.6 * (proxy - finger)[some]
    axes.quiver(*proxy[some].T, *way.T, color=look.FORCE, angles="xy", scale_units="xy", scale=1, width=0.005)
    axes.plot(*np.stack([finger[some], proxy[some]], axis=1).transpose(2, 1, 0), color=look.FAINT, linewidth=0.6)
    axes.set(xlim=(-75, 75), ylim=(-75, 75))


def _facet(shop):
    """The uppermost facet of a coarser and larger prism, felt as round."""
    turn = np.radians([66, 114])
    outward = np.column_stack([np.cos(turn), np.sin(turn)])[::-1]
    outline = 60e-3 * outward
    outline[:, 1] -= outline[0, 1]
    return shop.file("facet.obj", extruded(outline, 60e-3, outward)), outline, outward


def passes(shop, path):
    """One step in which the finger, held by a facet, jumps to the right."""
    scene, outline, outward = _facet(shop)
    radius, depth = 3e-3, 9e-3
    below, beside = [3e-3, radius - depth], [11e-3, radius - depth]
    rows = [[0, 3e-3, radius + 1e-3], *[[1e-3 * k, *below] for k in range(1, 40)], [40e-3, *beside]]
    run = shop.touch(scene, np.column_stack([np.array(rows), np.zeros(len(rows))]), proxy_radius=radius,
                     stiffness=500, shading="on")
    start, u, end = (1e3 * p[:2] for p in (run.proxy[-2], run.finger[-1], run.proxy[-1]))

    def felt(x):
        share = (1e-3 * x - outline[0, 0]) / (outline[1, 0] - outline[0, 0])
        normal = (1 - share) * outward[0] + share * outward[1]
        return normal / np.linalg.norm(normal)

    figure, (first, last) = look.sheet(9.6, 3.0, 1, 2)
    for axes, title, at in ((first, "a  A step begins: both passes", start), (last, "b  Where the step ends", end)):
        look.picture(axes, title)
        axes.fill_between([-20, 20], 0, -14, color=look.SOLID)
        axes.plot([-20, 20], [0, 0], color=look.SURFACE, linewidth=2)
        for x in np.linspace(-18, 18, 13):
            look.arrow(axes, (x, 0), (x, 0) + 2.6 * felt(x), look.FAINT, 0.8)
        normal, along_plane = felt(at[0]), np.array([felt(at[0])[1], -felt(at[0])[0]])
        axes.plot(*np.array([at - 11 * along_plane, at + 13 * along_plane]).T, "--", color=look.PROXY, linewidth=1)
        look.arrow(axes, at, at + 5 * normal, look.PROXY)
        look.ball(axes, at, 1e3 * radius)
        axes.plot(*u, "o", color=look.FINGER, markersize=6)
        axes.text(*(u + [1, -1.5]), "finger", color=look.FINGER)
        axes.set(xlim=(-20, 20), ylim=(-10, 10))
    subgoal = u + max(felt(start[0]) @ (start - u), 0) * felt(start[0])
    look.arrow(first, u, subgoal)
    look.arrow(first, subgoal, (subgoal[0], 1e3 * radius))
    first.plot(*subgoal, "o", color=look.FORCE, markersize=4)
    first.text(subgoal[0] - 1.2, -1.5, "1", color=look.FORCE)
    first.text(subgoal[0] - 1.2, 1e3 * radius + 0.3, "2", color=look.FORCE)
    first.plot([-20, 20], [1e3 * radius] * 2, color=look.PROXY, linewidth=0.6, alpha=0.5)
    look.arrow(last, u, end)
    last.text(*(0.5 * (u + end) + [0.8, -0.8]), "force", color=look.FORCE)
    look.save(figure, path)


def _lean(run):
    """Angle from the radial direction to the force, and the angle around the prism, in degrees."""
    around = np.unwrap(np.arctan2(run.finger[:, 1], run.finger[:, 0]))
    force = np.arctan2(run.force[:, 1], run.force[:, 0])
    lean = (force - around + np.pi) % (2 * np.pi) - np.pi
    return np.degrees(around), np.degrees(lean)


def prism(shop, path):
    figure, axes = look.pyplot.subplot_mosaic([["flat", "shaded", "round"], ["lean"] * 3], figsize=(9.6, 5.6),
                                              layout="constrained", height_ratios=[1.6, 1])
    cases = (("flat", SIDES, "off", look.SLIP, "a  Ten sides, no shading"),
             ("shaded", SIDES, "on", look.PROXY, "b  The same, shaded"),
             ("round", ROUND, "off", look.FORCE, "c  A true cylinder"))
    for name, sides, shading, colour, title in cases:
        run = _around(shop, sides, shading)
        _plan(axes[name], run, sides, title)
        broad = {"linewidth": 5, "alpha": 0.3} if name == "round" else {}
        every = slice(None, None, 20 if broad else 5)
        axes["lean"].plot(*_lean(run.rows(every)), color=colour, label=title[3:], **broad)
    axes["lean"].set(xlabel="finger around the axis, degrees", ylabel="force to radius,\ndegrees", xlim=(0, 360),
                     xticks=range(0, 361, 36), title="d  How far the force leans from the radius")
    axes["lean"].grid(axis="x")
    axes["lean"].legend(ncols=3, loc="upper center", bbox_to_anchor=(0.5, -0.3))
    look.save(figure, path)
