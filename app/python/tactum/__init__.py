"""Tactum from Python: scenes opened, changed and touched here, and the haptic server of a device.

    import tactum
    scene = tactum.open("teapot.glb")
    scene.set(static_friction=0.4)
    touch = scene.touch(path)                 # rows of t, x, y, z: numpy in, numpy out
    print(touch.force)

The first half needs numpy alone; Client, Hand, State, connect and serve, for the server, need python3-grpcio as well. SI
throughout: metre, second, newton, kilogram, radian; the world's frame, y up. docs/python.md has the whole of it.
"""

import importlib

from tactum.results import Error, Touch

_NATIVE = ["Body", "Contact", "Joint", "Layer", "Mask", "Object", "Parameter", "Place", "Preset", "Reading", "Recording",
           "Scene", "Step", "Surface", "World", "open", "parameters", "play", "presets"]
_SERVER = ["Client", "Hand", "State", "connect", "serve"]
__all__ = sorted(["Error", "Touch"] + _NATIVE + _SERVER)


def __getattr__(name):
    """Each half when it is asked for: the other one may not be there."""
    if name in _NATIVE:
        return getattr(_part("tactum._tactum", "this build has no compiled part: install pybind11-dev and python3-dev, and "
                             "build again"), name)
    if name in _SERVER:
        return getattr(_part("tactum.server", "the server's client needs python3-grpcio and python3-protobuf: install "
                             "them"), name)
    raise AttributeError(f"module 'tactum' has no attribute '{name}'")


def _part(module, remedy):
    try:
        return importlib.import_module(module)
    except ModuleNotFoundError as error:
        raise Error(f"there is no {error.name}; {remedy}") from None


def __dir__():
    return __all__
