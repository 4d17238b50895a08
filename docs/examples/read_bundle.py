#!/usr/bin/env python3
"""Opens a Tactum bundle and works out on its own what the finger must feel: plain Python, no library of Tactum's.

    python3 read_bundle.py scene.zip

It knows one flat surface with static, dynamic and viscous friction, which is what friction is checked with; curved and
textured surfaces are for whole renderers. It prints the largest difference from the forces in the bundle and ends with 1 when
that is above 1e-9 N. Everything is in metres, seconds and newtons.
"""
import csv, hashlib, io, json, math, struct, sys, zipfile


def dot(a, b): return sum(x * y for x, y in zip(a, b))
def add(a, b, by=1.0): return [x + by * y for x, y in zip(a, b)]
def length(a): return math.sqrt(dot(a, a))
def cross(a, b): return [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]


def open_bundle(name):
    """The files by name, each as its manifest says."""
    archive = zipfile.ZipFile(name)
    manifest = json.loads(archive.read("manifest.json"))
    files = {each["name"]: archive.read(each["name"]) for each in manifest["files"]}
    for each in manifest["files"]:
        if hashlib.sha256(files[each["name"]]).hexdigest() != each["sha256"]:
            sys.exit(f"{name}: {each['name']} is not the file that was exported")
    return files


def rows_of(table):
    """Numbers of a CSV without its header."""
    return [[float(x) for x in row] for row in list(csv.reader(io.StringIO(table.decode())))[1:]]


def flat_surface(glb):
    """A point, the upward normal and the material of the one plane that all triangles lie in."""
    json_length = struct.unpack_from("<I", glb, 12)[0]
    scene, data = json.loads(glb[20:20 + json_length]), glb[28 + json_length:]
    plane = None
    for node in scene["nodes"]:
        if "mesh" not in node: continue
        for part in scene["meshes"][node["mesh"]]["primitives"]:
            accessor = scene["accessors"][part["attributes"]["POSITION"]]
            view = scene["bufferViews"][accessor["bufferView"]]
            start = view.get("byteOffset", 0) + accessor.get("byteOffset", 0)
            points = [list(struct.unpack_from("<3f", data, start + 12 * i)) for i in range(accessor["count"])]
            x, y, z, w = node.get("rotation", [0, 0, 0, 1])
            turned = [add(add(p, cross([x, y, z], add(cross([x, y, z], p), p, w)), 2), node.get("translation", [0, 0, 0]))
                      for p in points]
            normal = next(n for q in turned for r in turned
                          for n in [cross(add(q, turned[0], -1), add(r, turned[0], -1))] if length(n) > 0)
            normal = [c / length(normal) for c in normal]
            normal = normal if normal[1] >= 0 else [-c for c in normal]
            plane = plane or (turned[0], normal, scene["materials"][part["material"]]["extensions"]["TACTUM_haptics"])
            if any(abs(dot(add(p, plane[0], -1), plane[1])) > 1e-6 for p in turned):
                sys.exit("more than one plane: that is beyond this reader")
    return plane, scene["extensions"]["TACTUM_haptics"]["proxyRadius"]


class Proxy:
    """Where the sphere is that stays outside (Ruspini and Khatib 2001, sections 2 and 4)."""

    def __init__(self, plane, radius):
        (self.point, self.normal, self.feel), self.radius = plane, radius
        self.position, self.finger, self.touching, self.slipping = None, None, False, False

    def height(self, p): return dot(add(p, self.point, -1), self.normal) - self.radius

    def force(self, finger, dt):
        before = self.position or finger
        velocity = [0, 0, 0] if self.finger is None else [(a - b) / dt for a, b in zip(finger, self.finger)]
        self.position, self.finger = before, finger
        left, depth = dt, -self.height(finger)
        if depth <= 0:  # in the open the proxy is where the finger is
            self.position, self.touching, self.slipping = finger, False, False
        elif not self.touching:  # to where the sphere meets the plane, and along it in what is left of the time
            part = self.height(before) / (self.height(before) + depth)
            self.position, self.touching, left = add(before, add(finger, before, -1), part), True, dt * (1 - part)
        if depth > 0: self.slide(finger, velocity, depth, left)
        if length(add(self.position, before, -1)) <= 1e-9 * self.radius: self.slipping = False
        stretch = add(self.position, finger, -1)
        inward = max(0.0, -dot(velocity, stretch) / length(stretch)) if length(stretch) > 0 else 0.0
        scale = self.feel["stiffness"] + (self.feel["damping"] * inward / length(stretch) if inward > 0 else 0.0)
        return [scale * c for c in stretch]

    def slide(self, finger, velocity, depth, dt):
        along = add(add(finger, self.normal, depth), self.position, -1)
        excess = length(along)
        if excess <= self.feel["dynamicFriction" if self.slipping else "staticFriction"] * depth: return
        self.slipping = True
        most = excess - self.feel["dynamicFriction"] * depth
        lag, slide = self.feel["viscosity"] / self.feel["stiffness"], max(0.0, most)
        if most > 0 and lag > 0:  # equation (21), solved over the part of the time outside of the cone
            speed = dot(velocity, along) / excess
            start, time = max(most - speed * dt, 0.0), most / speed if most < speed * dt else dt
            slide = min(most, max(0.0, most - speed * lag - (start - speed * lag) * math.exp(-time / lag)))
        self.position = add(self.position, along, slide / excess)


def main(name):
    files = open_bundle(name)
    plane, radius = flat_surface(files["scene.glb"])
    proxy, worst, most, before = Proxy(plane, radius), 0.0, 0.0, None
    for (t, *finger), felt in zip(rows_of(files["finger.csv"]), rows_of(files["forces.csv"])):
        force = proxy.force(finger, 1e-3 if before is None else t - before)
        worst, most, before = max(worst, length(add(force, felt[7:10], -1))), max(most, length(force)), t
    print(f"largest force {most:.6g} N, largest difference from the bundle {worst:.3g} N")
    return 0 if worst <= 1e-9 else 1


if __name__ == "__main__":
    sys.exit(main(sys.argv[1]) if len(sys.argv) == 2 else "usage: read_bundle.py BUNDLE.zip")
