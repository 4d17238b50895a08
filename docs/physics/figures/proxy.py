"""Figures 2 and 3 of the paper: the finger goes down into a groove, felt by the program."""

import numpy as np

from . import look
from .touch import along, extruded

RADIUS = 5e-3
LEFT, BOTTOM, RIGHT = np.array([-30e-3, 24e-3]), np.array([0.0, 0.0]), np.array([40e-3, 10e-3])


def _normal(begin, end):
    way = (end - begin) / np.linalg.norm(end - begin)
    return np.array([-way[1], way[0]])


NORMALS = np.array([_normal(LEFT, BOTTOM), _normal(BOTTOM, RIGHT)])


def _run(shop):
    scene = shop.file("groove.obj", extruded([LEFT, BOTTOM, RIGHT], 0.1))
    finger = along([(-18e-3, 32e-3), (-18e-3, 8e-3), (-1e-3, -10e-3)], 0.1)
    return shop.touch(scene, finger, proxy_radius=RADIUS, stiffness=500)


def _inner_corner():
    """The edge of the configuration space: a radius above both walls."""
    return np.linalg.solve(NORMALS, NORMALS @ BOTTOM + RADIUS)


def _walls(axes, c_obstacle):
    line = 1e3 * np.array([LEFT, BOTTOM, RIGHT])
    axes.fill([*line[:, 0], line[2, 0], line[0, 0]], [*line[:, 1], -16, -16], color=look.SOLID, zorder=0)
    axes.plot(*line.T, color=look.SURFACE, linewidth=2)
    axes.set(xlim=(-31, 41), ylim=(-16, 40))
    if c_obstacle:
        grown = 1e3 * np.array([LEFT + RADIUS * NORMALS[0], _inner_corner(), RIGHT + RADIUS * NORMALS[1]])
        axes.fill([*line[:, 0], *grown[::-1, 0]], [*line[:, 1], *grown[::-1, 1]], color=look.PROXY, alpha=0.1,
                  linewidth=0)
        axes.plot(*grown.T, color=look.PROXY, linewidth=1, linestyle="--")


def _moments(run):
    """In the air, on the left wall, and in the corner."""
    away = np.linalg.norm(1e3 * (run.proxy[:, :2] - _inner_corner()), axis=1)
    lift = np.linalg.norm(run.proxy - run.finger, axis=1)
    on_wall = np.flatnonzero((lift > 5e-3) & (away > 4))
    return 0, on_wall[len(on_wall) // 2], len(run.t) - 1


def _actual(axes, run):
    look.picture(axes, "a  The proxy stays outside")
    _walls(axes, False)
    axes.plot(*1e3 * run.finger[:, :2].T, color=look.FINGER, linewidth=1)
    axes.plot(*1e3 * run.proxy[:, :2].T, color=look.PROXY, linewidth=1)
    for k in _moments(run):
        finger, proxy = 1e3 * run.finger[k, :2], 1e3 * run.proxy[k, :2]
        look.ball(axes, proxy, 1e3 * RADIUS)
        axes.plot(*np.array([finger, proxy]).T, color=look.FORCE, linewidth=1.4)
        axes.plot(*finger, "o", color=look.FINGER, markersize=5)
    axes.text(-20, 10, "finger", color=look.FINGER, ha="right")
    axes.text(-11, 33, "proxy", color=look.PROXY)
    axes.text(0.5, -3, "force", color=look.FORCE)


def _configuration(axes, run):
    look.picture(axes, "b  As a point, kept by two planes")
    _walls(axes, True)
    _, wall, corner = _moments(run)
    for k, planes in ((wall, [0]), (corner, [0, 1])):
        finger, proxy = 1e3 * run.finger[k, :2], 1e3 * run.proxy[k, :2]
        for i in planes:
            look.arrow(axes, proxy, proxy + 9 * NORMALS[i], look.PROXY)
            if k == corner:
                axes.text(*(proxy + 11.5 * NORMALS[i]), rf"$\hat n_{i + 1}$", color=look.PROXY, ha="center",
                          va="center")
        axes.plot(*np.array([finger, proxy]).T, ":", color=look.FORCE)
        axes.plot(*finger, "o", color=look.FINGER, markersize=5)
        axes.plot(*proxy, "o", color=look.PROXY, markersize=5)
    axes.text(*(finger + [2, -1.5]), "u", color=look.FINGER, style="italic")
    axes.text(*(proxy + [-3.5, -3.2]), "x", color=look.PROXY, style="italic")


def _dual(axes, run):
    """The triangle of equation (17) for the last row, with the finger inside: the proxy does not move."""
    look.picture(axes, "c  The dual: within the hull")
    u = run.finger[-1, :2] - run.proxy[-1, :2]
    u = u / np.linalg.norm(u)
    corners = np.array([[0, 0], *(n / (u @ n) for n in NORMALS)])
    axes.fill(*corners.T, facecolor=look.PROXY, alpha=0.12)
    axes.fill(*corners.T, fill=False, edgecolor=look.PROXY)
    turn = np.linspace(0, 2 * np.pi, 100)
    axes.plot(np.cos(turn), np.sin(turn), ":", color=look.FAINT, linewidth=1)
    axes.plot(*u, "o", color=look.FINGER, markersize=6)
    axes.text(*(1.13 * u), r"$\hat u$", color=look.FINGER, ha="center", va="top")
    for i, corner in enumerate(corners[1:]):
        axes.plot(*corner, "o", color=look.PROXY, markersize=4)
        axes.text(*(corner * 1.1 + [0, 0.02]), rf"$c_{i + 1}\hat n_{i + 1}$", color=look.PROXY, ha="center", va="top")
    axes.text(0.05, 0.06, "0")
    axes.margins(0.15)


def corner(shop, path):
    run = _run(shop)
    figure, (actual, configuration, dual) = look.sheet(9.6, 3.1, 1, 3, width_ratios=[1.3, 1.3, 1])
    _actual(actual, run)
    _configuration(configuration, run)
    _dual(dual, run)
    look.save(figure, path)
