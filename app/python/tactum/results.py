"""What both halves of the package share: what was felt, and what could not be done."""
from __future__ import annotations

import dataclasses
from typing import Optional

import numpy as np
import numpy.typing


class Error(Exception):
    """What could not be done, in one sentence: what, where, and what to do."""


@dataclasses.dataclass
class Touch:
    """What was felt along a path, a row for each of its rows; of a sweep with an axis more in front.

    World's frame, y up. The same from Scene.touch(), from a World, from a recording and from the server's replay()."""

    proxy: numpy.typing.NDArray[np.float64]
    """(..., n, 3) in m: where the proxy is, which stays outside of everything."""
    force: numpy.typing.NDArray[np.float64]
    """(..., n, 3) in N on the finger, before any device's limit."""
    contacts: numpy.typing.NDArray[np.int64]
    """(..., n): how many places push."""
    t: Optional[numpy.typing.NDArray[np.float64]] = None
    """(..., n) in s: the times of the path."""
    finger: Optional[numpy.typing.NDArray[np.float64]] = None
    """(..., n, 3) in m: the places of the path."""


Error.__module__ = Touch.__module__ = "tactum"
