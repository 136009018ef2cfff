"""Linear systems for the tests of responses, of every kind that breaks solvers, and what they are measured against."""

import numpy as np
from mpmath import mp

from vibcli.analyses.excitation.forcing import Forcing, Segment, Wave
from vibcli.analyses.excitation.linear_output import LinearOutput
from vibcli.analyses.transient.high_precision import precise_motion
from vibcli.analyses.transient.linear_response import linear_motion

EPS = 2.0**-52
BITS, MORE, TRIES = 131, 96, 12     # of the first reference, and of each further one until two agree to 20 digits
FREE, STEP = (Segment(0.0),), (Segment(0.0, (Wave(0, 1.0, 0, 0j),)),)


def q(i):
    return LinearOutput(q={i: 1.0})


def v(i):
    return LinearOutput(v={i: 1.0})


def one(m, c, k, pieces=FREE, x=0.0, speed=0.0):
    """The motion of one degree of freedom."""
    return linear_motion([[m]], [[c]], [[k]], Forcing(1, pieces), [x], [speed])


def chain(stiffnesses, grounded=True):
    """K of masses in a row."""
    n = len(stiffnesses)
    K = np.zeros((n, n))
    for i, k in enumerate(stiffnesses):
        if i:
            K[i - 1:i + 1, i - 1:i + 1] += [[k, -k], [-k, k]]
        elif grounded:
            K[0, 0] += k
    return K


def systems(rng):
    """(name, M, C, K), one of each kind."""
    n = int(rng.integers(2, 5))
    B, D, G = rng.normal(size=(n, n)), rng.normal(size=(n, 2)), rng.normal(size=(n, n))
    S, M, C, one_ = B @ B.T, np.diag(rng.uniform(1, 3, n)), D @ D.T, np.eye(n)
    whole = rng.integers(1, 8, n).astype(float)
    lowest = np.sqrt(np.linalg.eigvalsh(chain(np.full(n, 4.0)))[0])
    heavy, unit = 10.0 ** rng.uniform(-9, 3, n), np.zeros((2, 2))
    scaled = np.sqrt(heavy)[:, None] * S * np.sqrt(heavy)
    return [
        ("damped", M, 0.1 * C, S), ("full inertia", S + one_, 0.1 * C, chain(rng.uniform(1, 5, n))),
        ("weakly damped", M, 1e-9 * C, S), ("undamped", M, 0 * C, S),
        ("free", M, 0.1 * chain(whole, False), chain(whole, False)), ("free, undamped", M, 0 * C, chain(whole, False)),
        ("free, a dashpot", M, np.diag([1.0] + [0.0] * (n - 1)), chain(whole, False)),
        ("critical", one_, 6 * one_, 9 * one_), ("one mode critical", one_, 2 * lowest * one_, chain(np.full(n, 4.0))),
        ("repeated", one_, 0.2 * one_ + 0.1, 9 * one_), ("heavily damped", M, 1e8 * C + 1e7 * one_, S + one_),
        ("stiff", M, 0.01 * C, chain(10.0 ** rng.uniform(0, 6, n))), ("gyroscopic", M, 3 * (G - G.T), S + one_),
        ("circulatory", M, 2 * one_, S + G - G.T), ("flutter begins", np.eye(2), unit, np.array([[2.0, 1], [-1, 4]])),
        ("four equal roots", np.eye(2), np.array([[2.0, 1], [0, 2]]), np.eye(2)),
        ("a defective pair", np.eye(2), np.array([[0.2, 1], [0, 0.2]]), np.array([[4.0, 2], [0, 4]])),
        ("drifting", M, 0 * C, 0 * S), ("dragged", M, one_, 0 * S), ("one dashpot", M, C, 0 * S),
        ("all units", np.diag(heavy), 0.1 * scaled, scaled)]


def rates(M, C, K):
    """The eigenvalues in floats, good enough to choose times and loads by."""
    n = len(M)
    return np.linalg.eigvals(np.block([[np.zeros((n, n)), np.eye(n)],
                                       [-np.linalg.solve(M, K), -np.linalg.solve(M, C)]]))


def case(M, C, K, rng):
    """(motion, times, fastest rate): a start, and loads at and next to resonance, a ramp, a step, a decaying wave."""
    n, found = len(M), rates(M, C, K)
    fastest = np.abs(found).max() or 1.0
    slowest = min((abs(x) for x in found if abs(x) > 1e-6 * fastest), default=fastest)
    turning = [abs(x.imag) for x in found if abs(x.imag) > max(1e-3 * abs(x), 1e-6 * fastest)]
    Omega = turning[0] if turning else slowest
    near = complex(found[0]) * (1 - 1e-9) if found[0].real <= 0 else -0.1j * Omega
    forcing = Forcing(n, [
        Segment(0.0, (Wave(0, 1.0, 0, 1j * Omega), Wave(1, 1.0, 1, 0j), Wave(0, 0.5, 0, 0j))),
        Segment(2 / Omega, (Wave(0, 1.0, 0, near), Wave(1, 1 - 1j, 1, complex(-0.3, 0.7) * Omega)), ((0, 0.3),))])
    size = np.sqrt(np.diagonal(M))
    motion = linear_motion(M, C, K, forcing, rng.normal(size=n) / size, rng.normal(size=n) * fastest / size)
    times = [0.01 / fastest, 3 / fastest, 1.5 / Omega, 4 / Omega, 30 / slowest, 1000 / slowest]
    growth = found.real.max()
    return motion, sorted(t for t in times if growth < 1e-5 * fastest or t * growth < 30), fastest


def exact_values(motion, outputs, times):
    """[values of the outputs at each instant] to 20 digits of the largest so far, of ascending instants: what is passed
    on the way to several is passed once."""
    lists, found, bits = [matrix.tolist() for matrix in (motion.M, motion.C, motion.K)], [], BITS
    for _ in range(TRIES):
        before = found
        with mp.workprec(bits + 64):
            precise = precise_motion(*lists, motion.forcing, motion.q0, motion.v0)
            found = [[precise.at(t, bits).read(output) for output in outputs] for t in times]
            if before and all(map(_agree, zip(*found, strict=True), zip(*before, strict=True))):
                break
        bits += max(MORE, bits // 3)
    return found


def _agree(found, before):
    """Are values of an output those found before, to 21 digits of the largest so far?"""
    largest = mp.mpf(0)
    for x, y in zip(found, before, strict=True):
        largest = max(largest, abs(x))
        if abs(x - y) > largest * mp.mpf(10)**-21:
            return False
    return True


def errors(motion, times, fastest):
    """For each time the error of all coordinates and speeds over the largest of them up to then, each in its unit."""
    n = len(motion.M)
    unit = np.append(fastest * np.sqrt(np.diagonal(motion.M)), np.sqrt(np.diagonal(motion.M)))
    outputs = [q(i) for i in range(n)] + [v(i) for i in range(n)]
    here = np.array([motion.values(output, times) for output in outputs]).T
    before = np.concatenate([np.linspace(0, t, 120) for t in times])
    largest = [np.abs(motion.values(output, before).reshape(-1, 120)).max(axis=1) * size
               for output, size in zip(outputs, unit, strict=True)]
    gaps = np.array([[float(abs(x - y)) for x, y in zip(found, exact, strict=True)]
                     for found, exact in zip(here, exact_values(motion, outputs, times), strict=True)])
    return (gaps * unit).max(axis=1) / np.max(largest, axis=0)
