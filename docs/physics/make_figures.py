#!/usr/bin/python3
"""make_figures.py TACTUM LIST_SPHERES FOLDER [NAME...]: the figures of docs/physics, from runs of the program.

Needs python3-matplotlib. `ninja -C build/dev make-figures` builds both programs and makes them all.
"""

import sys
import tempfile
from pathlib import Path

sys.dont_write_bytecode = True  # leaves no folder behind among the pages

from figures import collision, friction, moving, proxy, shading, texture, z_width  # noqa: E402
from figures.touch import Workshop  # noqa: E402

FIGURES = {
    "corner.svg": proxy.corner,
    "prism.svg": shading.prism,
    "passes.svg": shading.passes,
    "friction-cone.svg": friction.cone,
    "viscous-approach.svg": friction.viscous,
    "bumps.svg": texture.bumps,
    "sine.svg": texture.sine,
    "stroked-samples.svg": texture.samples,
    "sphere-tree.png": collision.sphere_tree,
    "moving-plate.svg": moving.plate,
    "z-width.svg": z_width.z_width,
}


def main(tactum, list_spheres, folder, *names):
    with tempfile.TemporaryDirectory() as work:
        shop = Workshop(work, tactum, list_spheres)
        for name in names or FIGURES:
            FIGURES[name](shop, Path(folder) / name)


if __name__ == "__main__":
    if len(sys.argv) < 4:
        sys.exit(__doc__)
    main(*sys.argv[1:])
