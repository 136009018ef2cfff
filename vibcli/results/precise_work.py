"""How much work many digits of a small motion are, estimated before anything is computed."""

import math
from typing import TYPE_CHECKING, Any

from vibcli.base.errors import PhysicsError

if TYPE_CHECKING:
    from vibcli.analyses.transient.linear_response import LinearMotion
    from vibcli.base.work import Work
    from vibcli.results.signal import Signal

MOST = 600          # steps of a million products of short whole numbers
OWN = 0.05          # such steps of what is done beside those products
PASSED = 250        # short products that one entry of a known exponential costs
SPARE = 60          # digits that are computed beyond those asked for


def estimated_steps(signal: "Signal", until: float, digits: int) -> float:
    """About how many steps of a million products `digits` digits of a signal at an instant take, 0 of one that has no
    more: the exponential of the system with its loads over each of their unlike stretches, twice."""
    import numpy as np

    from vibcli.numerics.precision import price

    if not signal.source:
        return 0.0
    motion: Any = signal.source[0].alone
    count, unlike, width, speeds = (_of_records if motion.forcing.recorded else _of_segments)(motion, until)
    size = 2 * (len(motion.M) + width)
    rates = np.linalg.pinv(motion.M) @ np.abs(np.concatenate([motion.K, motion.C], axis=1))
    norm = max(1.0, np.abs(rates).sum(axis=1).max(initial=0.0), *speeds) * max(until, 1e-300) / count
    halvings = max(0.0, math.log2(norm)) + 8
    bits = (digits + SPARE) * math.log2(10) + 2 * halvings
    passed = unlike * (halvings + bits / 10) * size**3 * price(int(bits)) + count * PASSED * size**2
    return OWN + 2 * passed / 1e6


def _of_segments(motion: "LinearMotion", until: float) -> tuple[int, int, int, list[float]]:
    """(how many stretches there are, how many are unlike, how many functions drive the widest, their speeds)."""
    import numpy as np

    pieces = motion.forcing.segments(math.nextafter(until, math.inf), motion.work)
    lengths = np.diff([*(float(piece.start) for piece in pieces), until])
    unlike = len({(piece.waves, f"{length:.9g}") for piece, length in zip(pieces, lengths, strict=True)})
    return (len(pieces), unlike, max(sum(wave.power + 1 for wave in piece.waves) for piece in pieces),
            [abs(wave.exponent) for piece in pieces for wave in piece.waves])


def _of_records(motion: Any, until: float) -> tuple[int, int, int, list[float]]:
    """The same of stretches that are not told one by one: no two are alike."""
    count, waves = motion.forcing.count(until), motion.forcing.waves
    return (count, count, sum((wave.power + 1) * len(wave.shares) for wave in waves),
            [abs(wave.exponent) for wave in waves])


def require_quick(steps: float, digits: int, work: "Work", most: float = MOST) -> None:
    """PhysicsError where so many digits take long, with the estimate."""
    limit = most * work.patience
    if steps > limit:
        raise PhysicsError(f"--digits {digits} would take about {steps:.0f} steps of a million products each; {limit} "
                           "are the limit", "ask for fewer digits or instants, or for earlier ones, or allow more with "
                           f"--patience {math.ceil(steps / MOST)}")
