"""Two presets on one stroke: python3 two_presets.py [PLOT.png [PRESET PRESET]]"""
import sys

import numpy as np
import tactum
from strokes import plate_scene, press_and_slide, saved

names = sys.argv[2:4] or ["teflon-on-steel", "rubber-on-dry-concrete"]
path = press_and_slide()
touches = []
for name in names:
    preset = tactum.Preset(name)
    scene = plate_scene()
    scene.apply(preset)
    touches.append(scene.touch(path))
    sliding = touches[-1].force[-200:]
    ratio = -sliding[:, 0].mean() / sliding[:, 2].mean()
    print(f"{preset.name}: {sliding[:, 2].mean():.2f} N down, {ratio:.3f} of it along; {preset.values}")

with saved() as plot:
    for name, touch in zip(names, touches):
        plot.plot(touch.t, -touch.force[:, 0], label=name)
    plot.set_xlabel("time (s)")
    plot.set_ylabel("force against the stroke (N)")
    plot.legend()

apart = np.abs(touches[0].force - touches[1].force).max()
print(f"at most {apart:.3f} N apart")
sys.exit(0 if apart > 0.1 else 1)
