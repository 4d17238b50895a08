"""How much stiffer must a wall be to be told apart? Two down, one up, to the increment that is noticed in 71 % of the
trials. The observer here is simulated: it presses with the simulated hand, and judges what was felt with an error
of a few percent. With a device, ask a person instead: that is observer() below. python3 staircase.py [TRIALS]"""
import sys
import time

import numpy as np
import tactum
from strokes import add_plate

STANDARD = 500.0  # N/m
WEBER = 0.08  # of the simulated observer
random = np.random.default_rng(7)


def press(haptics, stiffness):
    """Presses the wall and says how stiff it felt, in N/m."""
    haptics.lead_hand((0, 0, 0.01))
    haptics.until(lambda state: state.contacts == 0)
    time.sleep(0.2)  # what taps thirty times a second is no hand but an oscillation, and is softened as one
    revision = haptics.material(stiffness=stiffness).revision
    haptics.lead_hand((0, 0, -0.004))
    state = haptics.until(lambda s: s.revision == revision and s.contacts and s.gain == 1 and
                          abs(s.force[2] - stiffness * (s.proxy[2] - s.finger[2])) < 0.02 * s.force[2])
    return state.force[2] / (state.proxy[2] - state.finger[2])


def observer(first, second):
    """Whether the second felt stiffer."""
    error = WEBER * STANDARD * random.standard_normal(2)
    return second + error[1] > first + error[0]


trials = int(sys.argv[1]) if len(sys.argv) > 1 else 40
increment, right, reversals, rising = 0.5 * STANDARD, 0, [], False
with tactum.serve(rate=250) as haptics:
    add_plate(haptics)
    haptics.arm()
    for trial in range(trials):
        noticed = observer(press(haptics, STANDARD), press(haptics, STANDARD + increment))
        right = right + 1 if noticed else 0
        turns = not noticed or right == 2
        if turns and rising != (not noticed):
            reversals.append(increment)
            rising = not noticed
        if not noticed:
            increment *= 1.4
        elif right == 2:
            increment, right = increment / 1.4, 0
        print(f"trial {trial + 1}: {'noticed' if noticed else 'missed'}, next +{increment:.0f} N/m")
print(f"threshold {np.mean(reversals[-6:] or [increment]) / STANDARD:.3f} of {STANDARD:.0f} N/m")
