#!/usr/bin/python3
"""Joins the pictures of make-screenshots' word `touch` to one that moves: join_pictures.py FOLDER OUT.gif

Wants python3-pil. All pictures share the colours of the middle one, so that nothing flickers, and what stays the same
is written once."""

import pathlib
import sys

from PIL import Image

PACE = 60 # ms, of a picture
REST = 700 # ms, of the last one
COLOURS = 240

folder, out = pathlib.Path(sys.argv[1]), sys.argv[2]
files = sorted(folder.glob("touch-*.png"))
if not files:
    sys.exit(f"{folder}: has no touch-*.png; run make-screenshots with the word touch")
pictures = [Image.open(file).convert("RGB") for file in files]
colours = pictures[len(pictures) // 2].quantize(COLOURS, method=Image.Quantize.MEDIANCUT)
frames = [picture.quantize(palette=colours, dither=Image.Dither.NONE) for picture in pictures]
frames[0].save(out, save_all=True, append_images=frames[1:], duration=[PACE] * (len(frames) - 1) + [REST], loop=0,
               optimize=True)
