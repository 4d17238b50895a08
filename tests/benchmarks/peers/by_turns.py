#!/usr/bin/python3
"""by_turns.py OURS THEIRS FOLDER: measures bench_haptics and a peer's program (chai3d.cpp) by turns on the
meshes of a folder, as `bench_haptics --write` fills it, and prints the figures for figures.json. Where OURS is
bench-pace both make one step a millisecond.

A machine that is shared changes its pace within minutes: each mesh is measured several times by both, one
right after the other, and each program counts at its fastest run."""

import json
import os
import pathlib
import subprocess
import sys
import tempfile

KEYS = "mean_us", "median_us", "p999_us", "max_us"
MEASURED = {"smallest": 5, "1.0M": 3, "4.0M": 2}  # how often; the largest take minutes


def is_paced(own):
    return os.path.basename(own) == "bench-pace"


def ours(program, folder, mesh):
    how = [] if is_paced(program) else ["--feel", "smooth", "--no-judge"]
    with tempfile.NamedTemporaryFile(suffix=".json") as out:
        subprocess.run([program, "--folder", folder, "--largest", "5000000", "--only", mesh, "--json", out.name] + how,
                       check=True, stdout=subprocess.DEVNULL)
        figures = json.load(open(out.name))
    figure = next(f for f in figures if f["mesh"] == mesh)
    return figure["rehearsed"] if is_paced(program) else figure


def theirs(program, folder, mesh, paced):
    return json.loads(subprocess.run([program, os.path.join(folder, mesh)] + ["--paced"] * paced, check=True,
                                     capture_output=True, text=True).stdout)


def pair(own, peer, folder, mesh):
    turns = next((n for size, n in MEASURED.items() if size in mesh), MEASURED["smallest"])
    runs = [(ours(own, folder, mesh), theirs(peer, folder, mesh, is_paced(own))) for _ in range(turns)]
    best = [min(column, key=lambda f: f["mean_us"]) for column in zip(*runs)]
    return {"mesh": mesh, "triangles": best[1]["triangles"], **{k: round(best[1][k], 2) for k in KEYS},
            "ours": {k: round(best[0][k], 2) for k in KEYS}}


def main(own, peer, folder):
    for finger in sorted(pathlib.Path(folder).glob("*.csv")):
        print(json.dumps(pair(own, peer, folder, finger.stem)), flush=True)


if __name__ == "__main__":
    if len(sys.argv) != 4:
        sys.exit(__doc__)
    main(*sys.argv[1:])
