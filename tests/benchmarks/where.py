#!/usr/bin/python3
"""where.py FOLDER: which part of a step the instructions are spent in, as a Markdown table.

FOLDER holds callgrind's results, one `callgrind.MESH.FEEL` for each. Inlined functions count to the one they
are in."""

import pathlib
import re
import subprocess
import sys

PARTS = [
    ("gathering", r"Gathering|::gather"),
    ("triangles by eights", r"\bLeaf\b|tangent"),
    ("nodes", r"Sweep::open|\bNode\b|SphereTree::sweep|sweepFrom"),
    ("exact tests", r"sweepSphere|sweepSegment|faceNormal|nearestOfEdges|Sweep::test"),
    ("proxy and planes", r"nearestPoint|closestPoint|Step::|moveAndUpdate"),
    ("rest", r""),
]


def parts_of(result):
    listing = subprocess.run(["callgrind_annotate", "--threshold=100", result], capture_output=True, text=True,
                             check=True).stdout
    spent = dict.fromkeys((name for name, _ in PARTS), 0)
    for number, function in re.findall(r"^ *([\d,]+) \([^)]*\)  (?:\S*?:)?(tactum::.*|\S+)", listing, re.M):
        part = next(name for name, pattern in PARTS if re.search(pattern, function))
        spent[part] += int(number.replace(",", ""))
    spent["rest"] -= sum(int(total.replace(",", "")) for total in
                         re.findall(r"^ *([\d,]+) \([^)]*\)  PROGRAM TOTALS", listing, re.M))
    return spent


def row(cells):
    return "| " + " | ".join(cells) + " |"


def main(folder):
    print(row(["mesh", "feel"] + [name + " %" for name, _ in PARTS]))
    print(row([":--", ":--"] + ["--:"] * len(PARTS)))
    for result in sorted(pathlib.Path(folder).glob("callgrind.*.*")):
        _, mesh, feel = re.fullmatch(r"(callgrind)\.(.*)\.(\w+)", result.name).groups()
        spent = parts_of(result)
        total = sum(spent.values())
        print(row([mesh, feel] + [f"{100 * number / total:.0f}" for number in spent.values()]))


if __name__ == "__main__":
    if len(sys.argv) != 2:
        sys.exit(__doc__)
    main(sys.argv[1])
