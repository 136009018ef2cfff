"""Estimates of the error of full motions against Taylor series in integers, by scenes at random:

    python tests/fuzz/full_bounds.py COUNT SEED [ACCURACY]

prints what is exceeded, and the median of estimate/error.
"""

import random
import sys
from pathlib import Path
from statistics import median

if __name__ == "__main__":
    sys.path.insert(0, str(Path(__file__).parents[1]))

import mpmath
import numpy as np
from fuzz.full import kinked, smooth
from fuzz.full.scene import Draw
from support.motions import problem

from vibcli.api.values import given_expression
from vibcli.base.errors import PhysicsError

DIGITS, INSTANTS = 40, 12
NOTHING = 1e-300


def drawn(seed):
    """The Moving of a seed."""
    source = random.Random(seed)
    kind = source.choice([(smooth, one) for one in smooth.KINDS] + [(kinked, one) for one in kinked.KINDS])
    return kind[0].moving(kind[1], Draw(source))


def signals(moving, motion, one):
    """[(name, signal, piecewise name)] of the coordinates with their rates."""
    names = motion.pieces[-1].series
    scene = one.scene
    for name in names:
        base, primes = name.rstrip("'"), name.count("'")
        if base in scene.coordinates or base in scene.dependent:
            yield name, one.response.state_signal(scene.symbol(base, primes))
        elif not base.isidentifier():
            yield name, one.response.signal(given_expression(name, "the signal").tree)


def compared(seed, longest=1e9, accuracy=None):
    """(its Moving, [(what, error, estimate)] of its numbers) of a scene, followed for `longest` as accurately as is
    asked."""
    moving = drawn(seed)
    moving = moving._replace(until=min(moving.until, longest, key=float))
    motion = moving.motion()
    one = problem(moving.text) if accuracy is None else problem(moving.text).with_accuracy(accuracy)
    trajectory = one.response.trajectory(float(moving.until))
    source, found = random.Random(seed + 1), []
    for name, signal in signals(moving, motion, one):
        for _ in range(INSTANTS):
            t = source.uniform(0, trajectory.end)
            value = float(signal.values(np.array([t]))[0])
            error = abs(motion.value(name, mpmath.mpf(t)) - value)
            found.append((f"{name}({t:.6g})", float(error), signal.error(t)))
        if name + "'" in motion.pieces[-1].series:
            found += _extremes(name, signal, motion, trajectory.end)
            found += _zeros(name, signal, motion, trajectory.end)
    return moving, found


def _extremes(name, signal, motion, end):
    """Of the largest and the smallest value, and their instants, where they are not at an end."""
    for sense in (1, -1):
        t, value = signal.extreme(0.0, end, sense)
        instants = [true for true in motion.zeros(name + "'") if abs(true - t) < 1e-4]
        if instants:
            true = min(instants, key=lambda x: abs(x - t))
            yield f"argmax({name}) {t:.6g}", float(abs(true - t)), signal.error_of_time(t)
            yield f"max({name}) {t:.6g}", float(abs(motion.value(name, true) - value)), signal.error(t)


def _zeros(name, signal, motion, end):
    """Of the first and the last passage through zero."""
    true = motion.zeros(name)
    found = signal.zeros(0.0, end)
    for t in (*found[:1], *found[-1:]):
        near = min(true, key=lambda x: abs(x - t), default=None)
        if near is not None and t > 0 and abs(near - t) < 1e-4:
            yield f"zero({name}) {t:.6g}", float(abs(near - t)), signal.error_of_time(t)


def main(count, seed, accuracy=None):
    ratios, exceeded, refused, kinds = [], 0, 0, {}
    with mpmath.workdps(DIGITS):
        for number in range(seed, seed + count):
            try:
                moving, found = compared(number, accuracy=accuracy)
            except PhysicsError as error:
                refused += 1
                print(number, drawn(number).kind, "refused:", error, flush=True)
                continue
            worst = [(error / max(estimate, NOTHING), what, error, estimate) for what, error, estimate in found]
            own = [estimate / error for _, error, estimate in found if error > 0]
            ratios += own
            kinds.setdefault(moving.kind, []).extend(own)
            over = [row for row in worst if row[0] > 1]
            exceeded += bool(over)
            for over_by, what, error, estimate in sorted(over)[-3:]:
                print(f"{number} {moving.kind} exceeded {over_by:.3g}: {what} off {error:.3g} estimate {estimate:.3g}",
                      flush=True)
    for kind, own in sorted(kinds.items()):
        print(f"{kind:20} {len(own):5} estimate/error: least {min(own):8.3g}  median {median(own):8.3g}")
    print(f"{count} scenes, {refused} refused, {exceeded} exceeded, {len(ratios)} numbers: estimate/error least "
          f"{min(ratios):.3g}, median {median(ratios):.3g}")
    return exceeded


if __name__ == "__main__":
    sys.exit(bool(main(int(sys.argv[1]), int(sys.argv[2]), *map(float, sys.argv[3:]))))
