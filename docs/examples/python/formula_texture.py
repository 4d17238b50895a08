"""A texture from a formula, felt at once: python3 formula_texture.py"""
import sys
import time

import numpy as np
import tactum
from strokes import add_plate, press_and_slide

WAVE, REPEAT = 2e-3, 8e-3  # m

x = np.linspace(0, 1, 256, endpoint=False)
waves = np.tile(0.5 + 0.5 * np.sin(2 * np.pi * x * REPEAT / WAVE), (256, 1))
with tactum.serve(rate=1000) as haptics:
    add_plate(haptics)
    begin = time.perf_counter()
    revision = haptics.texture(waves, strength=2e-4, size=REPEAT).revision
    haptics.until(lambda state: state.revision == revision)
    print(f"in the loop after {1e3 * (time.perf_counter() - begin):.1f} ms")
    path = press_and_slide(way=0.04)
    force = haptics.replay(path).force
sliding = force[-400:, 0]
spectrum = np.abs(np.fft.rfft(sliding - sliding.mean()))
wave = 400 * 0.05 / 1000 / np.argmax(spectrum)  # m: the stroke of 400 rows goes 0.05 m/s
print(f"the force waves by {np.ptp(sliding):.3f} N every {1e3 * wave:.2f} mm")
sys.exit(0 if abs(wave - WAVE) < 1e-4 else 1)
