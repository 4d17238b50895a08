"""Figure 8 of the paper, and the approach of its equation (21), on a plane."""

import numpy as np

from . import look
from .touch import STEP, along, extruded

RADIUS, STIFFNESS = 1e-3, 800
STATIC, DYNAMIC = 0.8, 0.5


def _plane(shop):
    return shop.file("plane.obj", extruded([(-0.2, 0), (0.2, 0)], 0.1))


def slip_of(places, least=1e-9):
    """In which steps the proxy moved over the surface, by at least so much in m."""
    return np.concatenate([[False], np.linalg.norm(np.diff(places, axis=0), axis=1) > least])


def _ratio(touch):
    """Tangential over normal force of the finger on the surface."""
    return -touch.force[:, 0] / np.maximum(touch.force[:, 1], 1e-12)


def stick_and_slip(axes, x, y, slips, **more):
    for which, colour, label in ((~slips, look.STICK, "sticks"), (slips, look.SLIP, "slips")):
        axes.plot(x, np.where(which | np.roll(which, -1), y, np.nan), color=colour, label=label, **more)


def _cone(axes, shop):
    # The finger wanders in depth and sideways; what is drawn is where it is seen from the proxy.
    t = np.arange(0, 3, STEP)
    depth = 3.2e-3 + 1.6e-3 * np.sin(2 * np.pi * 0.9 * t)
    way = 6e-3 * np.sin(2 * np.pi * 0.53 * t) + 4e-3 * np.sin(2 * np.pi * 1.31 * t)
    finger = np.column_stack([t, way, RADIUS - depth * np.minimum(1, t / 0.1), np.zeros_like(t)])
    run = shop.touch(_plane(shop), finger, proxy_radius=RADIUS, stiffness=STIFFNESS,
                     static_friction=STATIC, dynamic_friction=DYNAMIC).rows(slice(100, None))
    seen = 1e3 * (run.finger - run.proxy)
    slips = slip_of(run.proxy)
    look.picture(axes, "a  The finger seen from the proxy")
    axes.fill_between([-4.7, 4.7], -1, -5.4, color=look.SOLID, zorder=0)
    axes.plot([-4.7, 4.7], [-1, -1], color=look.SURFACE)
    for slope, style in ((STATIC, "-"), (DYNAMIC, "--")):
        axes.plot([-5.2 * slope, 0, 5.2 * slope], [-5.2, 0, -5.2], style, color=look.INK, linewidth=1.1)
    look.ball(axes, (0, 0), 1e3 * RADIUS)
    axes.scatter(*seen[~slips, :2].T, s=2.5, color=look.STICK, linewidths=0, rasterized=True)
    axes.scatter(*seen[slips, :2].T, s=2.5, color=look.SLIP, linewidths=0, rasterized=True)
    for slope, name in ((STATIC, r"$\mu_s$"), (DYNAMIC, r"$\mu_d$")):
        axes.text(5.3 * slope, -5.8, name, ha="center")
    axes.text(1.3, 0.5, "proxy", color=look.PROXY)
    axes.set(xlim=(-4.8, 4.8), ylim=(-6, 1.2), anchor="N")


def cone(shop, path):
    figure, axes = look.pyplot.subplot_mosaic([["cone", "ratio"], ["cone", "way"]], figsize=(9.6, 4.4),
                                              layout="constrained", width_ratios=[1, 1.25])
    _cone(axes["cone"], shop)
    down = RADIUS - 4e-3
    finger = along([(0, 1.5e-3), (0, down), (14e-3, down), (-2e-3, down), (4e-3, down)], 0.05)
    run = shop.touch(_plane(shop), finger, proxy_radius=RADIUS, stiffness=STIFFNESS,
                     static_friction=STATIC, dynamic_friction=DYNAMIC)
    pressed = run.rows(run.finger[:, 1] < down + 1e-9)
    slips = slip_of(pressed.proxy)
    top, bottom = axes["ratio"], axes["way"]
    for value, name in ((STATIC, r"$\mu_s$"), (DYNAMIC, r"$\mu_d$")):
        for sign, minus in ((1, ""), (-1, "−")):
            top.axhline(sign * value, color=look.FAINT, linewidth=0.8, zorder=0)
            top.text(pressed.t[-1] + 0.01, sign * value, minus + name, va="center")
    stick_and_slip(top, pressed.t, _ratio(pressed), slips)
    top.set(ylabel="$f_t / f_n$", title="b  Break away, slide, turn back, twice")
    top.legend(loc="upper center", bbox_to_anchor=(0.62, 0.95))
    bottom.plot(pressed.t, 1e3 * pressed.finger[:, 0], color=look.FINGER, label="finger")
    bottom.plot(pressed.t, 1e3 * pressed.proxy[:, 0], color=look.PROXY, label="proxy")
    bottom.set(xlabel="time, s", ylabel="place, mm")
    bottom.legend(loc="upper center", bbox_to_anchor=(0.78, 1.0))
    bottom.sharex(top)
    look.save(figure, path)


def _viscous_run(shop, viscosity, step, speed=0.1):
    """A finger that presses and then goes sideways at once, without static friction to hold it."""
    down = RADIUS - 4e-3
    press = along([(0, 1.5e-3), (0, down)], 0.1, step)
    press[:, 0] -= press[-1, 0]
    slide = along([(0, down), (60e-3, down)], speed, step)[1:]
    path = np.vstack([press, slide])
    path[:, 0] += 1
    run = shop.touch(_plane(shop), path, proxy_radius=RADIUS, stiffness=STIFFNESS, static_friction=0.3,
                     dynamic_friction=0.3, viscosity=viscosity)
    run.t = run.t - 1
    return run


def _closed_form(t, viscosity, speed=0.1, friction=0.3, depth=4e-3):
    """Held until the cone is left, then equation (21): an exponential approach to mu f_n + b v. In N."""
    left = friction * depth / speed
    lag = viscosity / STIFFNESS
    slid = np.maximum(t - left, 0)
    return np.where(t < left, STIFFNESS * speed * t,
                    STIFFNESS * friction * depth + viscosity * speed * (1 - np.exp(-slid / lag)))


def _multiplied_out(step, viscosity, until, speed=0.1, friction=0.3, depth=4e-3):
    """What the velocity of (21) times the time step would give instead."""
    t = np.arange(0, until, step)
    proxy, force = 0.0, []
    for now in t:
        velocity = (STIFFNESS * (speed * now - proxy) - STIFFNESS * friction * depth) / viscosity
        proxy += max(velocity, 0) * step
        force.append(STIFFNESS * (speed * now - proxy))
    return t, np.array(force)


def viscous(shop, path):
    figure, (left, right) = look.sheet(9.6, 3.7, 1, 2)
    t = np.linspace(0, 0.4, 400)
    for viscosity, colour in ((2, look.FORCE), (10, look.PROXY), (30, look.SLIP)):
        run = _viscous_run(shop, viscosity, STEP)
        run = run.rows((run.t >= 0) & (run.t <= 0.4))
        left.plot(t, _closed_form(t, viscosity), color=colour, linewidth=4, alpha=0.25)
        left.plot(run.t, -run.force[:, 0], color=colour, linewidth=1.4)
        left.text(0.405, 1.0 + 0.1 * viscosity, f"b = {viscosity}", color=colour, va="center")
    left.axhline(0.96, color=look.FAINT, linewidth=0.8, zorder=0)
    left.text(0.405, 0.8, r"$\mu_d f_n$", va="center")
    left.set(xlabel="time, s", ylabel="tangential force, N", title="a  Steady: $\\mu_d f_n + b v$")
    step, viscosity, until = 10e-3, 3, 0.3
    run = _viscous_run(shop, viscosity, step)
    run = run.rows((run.t >= 0) & (run.t <= until))
    t = np.linspace(0, until, 600)
    right.plot(t, _closed_form(t, viscosity), color=look.PROXY, linewidth=4, alpha=0.25, label="equation (21)")
    right.plot(*_multiplied_out(step, viscosity, until), "x-", color=look.FAINT, linewidth=1, markersize=5,
               label="velocity times time step")
    right.plot(run.t, -run.force[:, 0], "o", color=look.PROXY, markersize=4, label="Tactum")
    right.set(xlabel="time, s", ylim=(-0.4, 2.1), title="b  b = 3 N s/m in steps of 10 ms")
    right.legend(loc="upper right", ncols=3, columnspacing=1)
    look.save(figure, path)
