"""Figure 10 of the paper: the sphere tree over the teapot at several depths, as spheres and as what is tested."""

from pathlib import Path

import numpy as np

from . import look

SCENE = Path(__file__).resolve().parents[3] / "resources" / "scenes" / "teapot.obj"
DEPTHS = (0, 1, 2, 3)
COLOURS = np.array([[31, 111, 235], [217, 115, 13], [26, 127, 55], [130, 80, 223],
                    [207, 34, 46], [0, 140, 150], [191, 135, 0], [190, 75, 140]]) / 255
TOWARD_EYE = np.array([0.35, 0.42, 0.84]) / np.linalg.norm([0.35, 0.42, 0.84])
LIGHT = np.array([-0.35, 0.75, 0.56])
SAMPLES = 2  # a side of a pixel


class Screen:
    """Looks from far away; keeps for each pixel the nearest thing, its normal and its number."""

    def __init__(self, low, high, width):
        right = np.cross([0, 1, 0], TOWARD_EYE)
        self.right = right / np.linalg.norm(right)
        self.up = np.cross(TOWARD_EYE, self.right)
        self.pixel = (high[0] - low[0]) / width
        self.across = low[0] + self.pixel * (0.5 + np.arange(width))
        self.along = high[1] - self.pixel * (0.5 + np.arange(int((high[1] - low[1]) / self.pixel)))
        self.depth = np.full((len(self.along), len(self.across)), -np.inf)
        self.normal = np.zeros((*self.depth.shape, 3))
        self.owner = np.full(self.depth.shape, -1)

    def draw(self, number, centre, radius, normal, offset, thickness):
        """A sphere, and where normal is not 0 only what of it lies between its two planes."""
        column = np.abs(self.across - centre @ self.right) < radius
        row = np.abs(self.along - centre @ self.up) < radius
        if not column.any() or not row.any():
            return
        window = np.ix_(row, column)
        x = self.across[column][None, :] - centre @ self.right
        y = self.along[row][:, None] - centre @ self.up
        half = np.sqrt(np.maximum(radius**2 - x**2 - y**2, 0))
        inside = x**2 + y**2 < radius**2
        top, bottom = half, -half
        facing = x[..., None] * self.right + y[..., None] * self.up + top[..., None] * TOWARD_EYE
        facing = facing / radius
        slope = normal @ TOWARD_EYE
        if np.any(normal) and abs(slope) > 1e-6:
            height = x * (normal @ self.right) + y * (normal @ self.up) - offset
            first, second = (-thickness - height) / slope, (thickness - height) / slope
            flat = np.maximum(first, second)
            bottom = np.maximum(bottom, np.minimum(first, second))
            facing = np.where((flat < top)[..., None], normal * np.sign(slope), facing)
            top = np.minimum(top, flat)
        nearer = inside & (top >= bottom) & (top + centre @ TOWARD_EYE > self.depth[window])
        self.depth[window] = np.where(nearer, top + centre @ TOWARD_EYE, self.depth[window])
        self.normal[window] = np.where(nearer[..., None], facing, self.normal[window])
        self.owner[window] = np.where(nearer, number, self.owner[window])

    def image(self, colours):
        light = 0.42 + 0.6 * np.maximum(self.normal @ LIGHT, 0)
        shown = np.clip(colours[self.owner] * light[..., None] + 0.12, 0, 1)
        shown[self._outlines()] *= 0.45
        shown[self.owner < 0] = 1
        rows, columns = (n // SAMPLES * SAMPLES for n in self.owner.shape)
        blocks = shown[:rows, :columns].reshape(rows // SAMPLES, SAMPLES, columns // SAMPLES, SAMPLES, 3)
        return blocks.mean(axis=(1, 3))

    def _outlines(self):
        edge = np.zeros(self.owner.shape, bool)
        edge[1:] |= self.owner[1:] != self.owner[:-1]
        edge[:, 1:] |= self.owner[:, 1:] != self.owner[:, :-1]
        return edge


def _at(spheres, depth):
    """As SphereTree::spheresAt: of a branch that ends above this depth, its last sphere."""
    return [s for s in spheres if s["depth"] == depth or (s["depth"] < depth and s["leaf"])]


def _vector(sphere, *names):
    return np.array([sphere[name] for name in names])


def _window(spheres):
    screen = Screen((0, 0), (1, 1), 1)
    seen = np.array([[_vector(s, "x", "y", "z") @ axis for axis in (screen.right, screen.up)] for s in spheres])
    radius = 1.03 * np.array([[s["radius"]] for s in spheres])
    return (seen - radius).min(axis=0), (seen + radius).max(axis=0)


def _draw(spheres, window, flat, width):
    screen = Screen(*window, width)
    for number, s in enumerate(spheres):
        normal = _vector(s, "nx", "ny", "nz") if flat else np.zeros(3)
        screen.draw(number, _vector(s, "x", "y", "z"), s["radius"], normal, s["offset"], s["thickness"])
    tone = 0.85 + 0.3 * np.random.default_rng(1).random(len(spheres))
    branch = np.array([int(s["branch"]) for s in spheres])
    return screen.image(np.clip(COLOURS[branch] * tone[:, None], 0, 1))


def sphere_tree(shop, path):
    spheres = shop.spheres(SCENE)
    window = _window(_at(spheres, 0))
    figure, axes = look.sheet(9.6, 5.0, 2, len(DEPTHS))
    for column, depth in enumerate(DEPTHS):
        level = _at(spheres, depth)
        for row, flat in enumerate((False, True)):
            look.picture(axes[row, column], "" if flat else f"depth {depth}: {len(level):,}")
            axes[row, column].imshow(_draw(level, window, flat, 320 * SAMPLES), interpolation="antialiased")
    for row, name in enumerate(("spheres", "between their planes")):
        axes[row, 0].text(-0.04, 0.5, name, transform=axes[row, 0].transAxes, rotation=90, ha="right", va="center")
    look.save(figure, path)
