#!/usr/bin/python3
"""record.py RESULTS PEERS.json PAGE.md: puts what a run found (its folder of results) into the page.

A block of the page is what stands between the lines `<!-- NAME -->` and `<!-- /NAME -->`."""

import json
import pathlib
import re
import sys


def row(cells):
    return "| " + " | ".join(cells) + " |\n"


def beside(peer):
    """Ours and a peer's on the same meshes and fingers, measured by turns in the same hour."""
    table = row(["mesh", "ours: mean", "median", "p99.9", "max us", "theirs: mean", "median", "p99.9", "max us",
                 "times faster: mean", "median"])
    table += row([":--"] + ["--:"] * 10)
    for theirs in peer["figures"]:
        own = theirs["ours"]
        cells = [f"{f[key]:.2f}" if f[key] < 100 else f"{f[key]:,.0f}" for f in (own, theirs)
                 for key in ("mean_us", "median_us", "p999_us", "max_us")]
        cells += [f"{theirs[key] / own[key]:.1f}" for key in ("mean_us", "median_us")]
        table += row([theirs["mesh"]] + cells)
    return table


def growth(figures):
    """How the median grows from the smallest to the largest mesh of each family."""
    sentences = []
    for family, plural in ("sphere", "spheres"), ("height", "height fields"):
        sizes = sorted((f["triangles"], f["median_us"]) for f in figures
                       if f["feel"] == "smooth" and f["mesh"].startswith(family + "-"))
        (fewest, first), (most, last) = sizes[0], sizes[-1]
        sentences.append(f"From {fewest:,} to {most:,} triangles ({most / fewest:.0f} times as many) the median "
                         f"update grows {last / first:.1f} times on {plural}.")
    return "\n".join(sentences)


def blocks(results, peers):
    figures = json.loads((results / "figures.json").read_text())
    tables = (results / "tables.md").read_text().strip().split("\n\n")
    found = {"circumstances": tables[0], "speed": tables[1], "exactness": tables[2],
             "growth": growth(figures)}
    hierarchies = results / "hierarchies.md"
    if hierarchies.exists():
        found["hierarchies"] = hierarchies.read_text().strip().split("\n\n")[1]
    if (results / "where.md").exists():
        found["where"] = (results / "where.md").read_text()
    for peer in peers:
        if peer["same"]:
            found["beside " + peer["name"]] = beside(peer) + "\n" + peer["circumstances"]
    return found


def main(results, peers, page):
    page = pathlib.Path(page)
    text = page.read_text()
    for name, block in blocks(pathlib.Path(results), json.load(open(peers))).items():
        mark = re.escape(name)
        text, count = re.subn(rf"(<!-- {mark} -->\n).*?(<!-- /{mark} -->)",
                              lambda match: match[1] + block.strip() + "\n" + match[2], text, flags=re.S)
        if count != 1:
            sys.exit(f"{page}: the block <!-- {name} --> is there {count} times instead of once")
    page.write_text(text)


if __name__ == "__main__":
    if len(sys.argv) != 4:
        sys.exit(__doc__)
    main(*sys.argv[1:])
