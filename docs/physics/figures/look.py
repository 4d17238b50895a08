"""How all figures look."""

import re

import matplotlib

matplotlib.use("Agg")
matplotlib.rcParams.update({
    "svg.hashsalt": "figures",  # the same figures give the same file,
    "svg.fonttype": "path",  # and look the same whatever fonts there are
    "font.size": 10,
    "axes.spines.top": False,
    "axes.spines.right": False,
    "axes.titlesize": "medium",
    "axes.titleweight": "bold",
    "axes.titlelocation": "left",
    "grid.linewidth": 0.4,
    "grid.color": "#d0d7de",
    "legend.frameon": False,
    "legend.fontsize": "small",
    "lines.linewidth": 1.6,
})
from matplotlib import pyplot  # noqa: E402
from PIL import Image  # noqa: E402

FINGER, PROXY, FORCE = "#cf222e", "#1f6feb", "#1a7f37"
STICK, SLIP = "#1f6feb", "#d9730d"
SURFACE, SOLID, FAINT, INK = "#57606a", "#e6e9ed", "#b6bec8", "#24292f"


def sheet(width, height, *grid, **more):
    return pyplot.subplots(*grid, figsize=(width, height), layout="constrained", **more)


def picture(axes, title=""):
    """Axes for a drawing to scale, without numbers."""
    axes.set_aspect("equal")
    axes.axis("off")
    axes.set_title(title)


def ball(axes, at, radius, colour=PROXY, alpha=0.25, **more):
    axes.add_patch(pyplot.Circle(at, radius, facecolor=colour, edgecolor=colour, alpha=alpha, **more))
    axes.add_patch(pyplot.Circle(at, radius, fill=False, edgecolor=colour, linewidth=1.2, **more))


def arrow(axes, begin, end, colour=FORCE, width=1.4, **more):
    style = {"arrowstyle": "-|>", "color": colour, "linewidth": width, "shrinkA": 0, "shrinkB": 0,
             "mutation_scale": 9}
    axes.annotate("", xy=end, xytext=begin, arrowprops=style, **more)


def save(figure, path):
    figure.savefig(path, metadata={"Date": None} if path.suffix == ".svg" else None, dpi=200 if path.suffix == ".svg" else 110)
    pyplot.close(figure)
    if path.suffix == ".png":  # few colours make a small file
        Image.open(path).convert("RGB").quantize(96).save(path, optimize=True)
    else:  # and so do hundredths of a point
        path.write_text(re.sub(r' d="[^"]*"', _rounded, path.read_text()))


def _rounded(outline):
    return re.sub(r"-?\d+\.\d+", lambda number: f"{float(number[0]):.2f}", outline[0]).replace(" \n", "\n")
