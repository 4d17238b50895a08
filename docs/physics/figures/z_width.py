"""How stiff a wall each loop renders before it swings, from the baseline of the stability tests."""

import csv
from pathlib import Path

from . import look

BASELINE = Path(__file__).parents[3] / "tests/physics/z_width.csv"
COLOURS = {"none": look.FAINT, "pinch": look.FINGER, "grasp": look.SLIP, "firm": look.PROXY, "rigid": look.FORCE}


def z_width(_, path):
    rows = list(csv.DictReader(BASELINE.read_text().splitlines()))
    devices = list(dict.fromkeys(row["device"] for row in rows))
    figure, panels = look.sheet(9.6, 4, 1, len(devices), sharey=True)
    for axes, device in zip(panels, devices):
        for hand, colour in COLOURS.items():
            mine = [row for row in rows if row["device"] == device and row["hand"] == hand]
            for delays in (mine[i : i + 3] for i in range(0, len(mine), 3)):
                x = [mine.index(row) + mine.index(row) // 3 for row in delays]
                axes.plot(x, [float(row["first_failure"]) for row in delays], "o-", color=colour, markersize=3,
                          label=hand if delays[0] is mine[0] else None)
                axes.plot(x, [float(row["safe"]) for row in delays], ":", color=colour, linewidth=1.1)
        axes.set(title=device, yscale="log", ylim=(8, 2e4), xticks=[1, 5, 9], xticklabels=["1", "2", "4"],
                 xlabel="kHz; 0, 1 and 2 ticks late")
        axes.grid(axis="y")
    panels[0].set_ylabel("N/m")
    panels[0].legend(title="hand", ncols=2)
    look.save(figure, path)
