#!/usr/bin/python3
"""growth.py FIGURES.json PEERS.json PLOT: the median update over the number of triangles, ours and others'."""

import json
import sys

import matplotlib

matplotlib.use("Agg")
# The same figures give the same file, with letters as letters.
matplotlib.rcParams.update({"svg.hashsalt": "growth", "svg.fonttype": "none"})
from matplotlib import pyplot

FAMILIES = {"sphere": ("spheres", "o"), "height": ("height fields", "s")}
OURS, THEIRS = "#1f6feb", ["#b35900", "#7d8590", "#8250df"]


def series(figures, family):
    points = [(f["triangles"], f["median_us"]) for f in figures if f["mesh"].startswith(family + "-")]
    return sorted(points)


def draw(axes, figures, colour, style, label):
    for family, (plural, marker) in FAMILIES.items():
        points = series(figures, family)
        if points:
            axes.plot(*zip(*points), style, color=colour, marker=marker, markersize=5, label=f"{label}, {plural}")


def main(figures_file, peers_file, plot):
    figures = [f for f in json.load(open(figures_file)) if f["feel"] == "smooth"]
    figure, axes = pyplot.subplots(figsize=(8, 5), layout="constrained")
    draw(axes, figures, OURS, "-", "Tactum")
    for peer, colour in zip(json.load(open(peers_file)), THEIRS):
        draw(axes, peer["figures"], colour, ":", peer["name"])
    axes.set(xscale="log", yscale="log", xlabel="triangles", ylabel="median update, µs",
             title="A haptic update over the size of the mesh")
    axes.grid(True, which="both", linewidth=0.3)
    axes.legend(fontsize="small")
    figure.savefig(plot, metadata={"Date": None} if plot.endswith("svg") else None)


if __name__ == "__main__":
    if len(sys.argv) != 4:
        sys.exit(__doc__)
    main(*sys.argv[1:])
