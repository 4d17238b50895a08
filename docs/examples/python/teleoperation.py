"""A hand here leads a hand elsewhere, and feels what that one touches: two servers, each with its device, over their calls.
python3 teleoperation.py LEADER FOLLOWER, two addresses; without them two servers of its own with simulated hands, of
which the leading one is led into a plate that only the other one has."""
import contextlib
import sys
import time

import numpy as np
import tactum
from strokes import add_plate

RATE = 250.0  # Hz, of what goes to and fro


def couple(leader, follower):
    """Once: where the one is the other goes, and what the other feels pushes the one, up to what its server allows."""
    here, there = leader.state(), follower.state()
    follower.lead_hand(here.finger)
    leader.push(there.force)
    return here, there


def press(leader, follower, patience=60.0):
    """Leads the leading hand down until it is pushed; the force of both, in N."""
    leader.lead_hand((0, 0, -0.002))
    end = time.monotonic() + patience
    while time.monotonic() < end:
        here, there = couple(leader, follower)
        if there.contacts and here.force[2] > 0.9 * min(there.force[2], leader.welcome.push_limit) > 0.2:
            return here.force[2], there.force[2]
        time.sleep(1 / RATE)
    raise SystemExit("the leading hand felt nothing")


with contextlib.ExitStack() as open_ones:
    if len(sys.argv) == 3:
        leader, follower = (open_ones.enter_context(tactum.connect(address, rate=RATE)) for address in sys.argv[1:])
        while True:
            couple(leader, follower)
            time.sleep(1 / RATE)
    leader, follower = (open_ones.enter_context(tactum.serve(rate=RATE)) for _ in range(2))
    follower.material(object=add_plate(follower), stiffness=400)
    add_plate(leader, half=1e-3)
    leader.move(1, (0.05, 0, 0))  # out of the way
    for haptics in (leader, follower):
        haptics.lead_hand((0, 0, 0.01))
        haptics.arm()
        haptics.until(lambda state: state.gain == 1 and np.allclose(state.finger, (0, 0, 0.01), atol=1e-4))
    felt, touched = press(leader, follower)
    print(f"the following hand touches with {touched:.2f} N, the leading one feels {felt:.2f} N of it")
