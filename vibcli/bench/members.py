"""Frequencies and frequency responses of members: time after the element data, error against formulas in 40 digits;
beside what SciPy and NumPy take for the same by hand."""

from statistics import median
from time import process_time
from typing import TYPE_CHECKING

from vibcli.bench.rows import Timing

if TYPE_CHECKING:
    from collections.abc import Callable, Iterator, Sequence

    import mpmath

    from vibcli.analyses.modal.undamped import Mode
    from vibcli.results.problem import Problem

BEAM = "EI: 4 kN*m^2, mass_per_length: 3 kg/m"
CANTILEVER = "beams: {arm: {length: 2 m, " + BEAM + ", left: clamped%s}}\n"
TIP_MASS = CANTILEVER % ", attached: [{at: 2 m, mass: 3 kg}]"        # half of its own
TIP = 1.42, 4.11, 7.19       # βL of that, about
SUPPORTS = ", ".join(f"{{at: {i} m, support: pinned}}" for i in range(1, 60))
SPANS = f"beams: {{girder: {{length: 60 m, {BEAM}, left: pinned, right: pinned, attached: [{SUPPORTS}]}}}}\n"
STEPPED = """\
beams:
  arm:
    mass_per_length: 2 kg/m
    left: clamped
    segments: [{length: 0.5 m, EI: 100 N*m^2}, {length: 0.5 m, EI: 50 N*m^2}]
    attached: [{at: 0.3 m, mass: 0.2 kg}, {at: 0.7 m, k: 100 N/m}, {at: 1 m, mass: 0.1 kg}]
points: {tip: {body: arm, at: 1 m}}
forces: {drive: {at: tip, force: 1 N*sin(3 rad/s*t)}}
"""
PER_SPAN = 6         # elements
GRID, LOOKED_AT = 10_000, (1, 2, 3, 30, 1000)


def rows(runs: int) -> "Iterator[Timing]":
    """Those of uniform and of many-span beams, and of a frequency response on a grid."""
    import numpy as np

    from vibcli.analyses.continuous.uniform_members import uniform_member

    numbers = np.arange(1, 1001)
    spent, _ = _spent(CANTILEVER % "", runs,
                      lambda problem: uniform_member(problem.configuration.linear_system).frequencies(numbers))
    yield Timing("1,000 frequencies of a cantilever", 1e3 * spent, "ms", 0.2, "scipy brentq of each", _by_brentq(runs))
    spent, problem = _spent(CANTILEVER % "", runs, lambda problem: problem.modal.modes.first(1000))
    modes, unit = problem.modal.modes.first(1000), _unit(2)
    found = [modes[n - 1] for n in LOOKED_AT]
    yield Timing("  with their shapes", 1e3 * spent, "ms", None)
    yield Timing("  relative error of 1, 2, 3, 30, 1000", _error(found, unit, _cantilever(LOOKED_AT)), "", 1e-15,
                 absolute=True)
    spent, problem = _spent(TIP_MASS, runs, lambda problem: problem.modal.modes.first(3))
    found = problem.modal.modes.first(3)
    yield Timing("cantilever with a mass, relative error", _error(found, unit, _tip()), "", 4e-16, absolute=True)
    spent, _ = _spent(SPANS, min(runs, 3), lambda problem: problem.modal.modes.first(180))
    yield Timing("60 spans, 180 frequencies", 1e3 * spent, "ms", 1.6, f"scipy eigh, {PER_SPAN} elements a span",
                 _by_elements())
    at = 1j * np.linspace(1.0, 2000.0, GRID)
    spent, _ = _spent(STEPPED, runs, lambda problem: problem.frequency_response("arm.u(1 m)", "drive").transfer.at(at))
    yield Timing("stepped beam, 10,000 points of a frequency response", 1e3 * spent, "ms", 8.0,
                 "numpy solve, 10,000 × 6 × 6", _by_solving(runs))


def _spent(text: str, runs: int, ask: "Callable[[Problem], object]") -> "tuple[float, Problem]":
    """(median of the seconds of a question after the element data, the last Problem)."""
    from vibcli.api.source import problem_of, text_source

    spent = []
    for run in range(runs + 1):
        problem = problem_of(text_source(text))
        _ = problem.configuration.linear_system
        start = process_time()
        ask(problem)
        spent += [process_time() - start] if run else []        # the first imports
    return median(spent), problem


def _by_brentq(runs: int) -> float:
    """Milliseconds of the roots of cos x + 1/cosh x, one after another."""
    from math import cos, exp, pi

    from scipy.optimize import brentq

    def condition(x: float) -> float:
        return cos(x) + 2 * exp(-x) / (1 + exp(-2 * x))

    return _timed(lambda: [brentq(condition, (n - 1) * pi, n * pi, xtol=1e-15, rtol=1e-15) for n in range(1, 1001)],
                  min(runs, 3))


def _by_elements() -> float:
    """Milliseconds of the lowest 180 frequencies of the 60 spans by cubic finite elements."""
    import numpy as np
    from scipy.linalg import eigh

    count, h = 60 * PER_SPAN, 1 / PER_SPAN
    stiff = np.array([[12, 6 * h, -12, 6 * h], [6 * h, 4 * h * h, -6 * h, 2 * h * h], [-12, -6 * h, 12, -6 * h],
                      [6 * h, 2 * h * h, -6 * h, 4 * h * h]]) * 4000 / h**3
    mass = np.array([[156, 22 * h, 54, -13 * h], [22 * h, 4 * h * h, 13 * h, -3 * h * h], [54, 13 * h, 156, -22 * h],
                     [-13 * h, -3 * h * h, -22 * h, 4 * h * h]]) * 3 * h / 420
    K, M = np.zeros((2, 2 * count + 2, 2 * count + 2))
    for i in range(count):
        part = slice(2 * i, 2 * i + 4)
        K[part, part] += stiff
        M[part, part] += mass
    free = np.delete(np.arange(2 * count + 2), np.arange(0, 2 * count + 2, 2 * PER_SPAN))
    K, M = (matrix[np.ix_(free, free)] for matrix in (K, M))
    return _timed(lambda: eigh(K, M, subset_by_index=[0, 179]), 1)


def _by_solving(runs: int) -> float:
    """Milliseconds of solving with as many small dense matrices as there are points."""
    import numpy as np

    random = np.random.default_rng(3)
    matrices = random.normal(size=(GRID, 6, 6)) + 1j * random.normal(size=(GRID, 6, 6))
    return _timed(lambda: np.linalg.solve(matrices, np.ones((6, 1))), runs)


def _timed(ask: "Callable[[], object]", runs: int) -> float:
    spent = []
    for _ in range(runs):
        start = process_time()
        ask()
        spent.append(process_time() - start)
    return 1e3 * median(spent)


def _unit(length: float) -> "mpmath.mpf":
    """√(EI/(μL⁴))."""
    from mpmath import mpf, sqrt

    return sqrt(mpf(4000) / 3) / length**2


def _error(modes: "Sequence[Mode]", unit: "mpmath.mpf", wave_numbers: "Sequence[mpmath.mpf]") -> float:
    """The largest relative error of ω = unit·(βL)²."""
    return max(float(abs(mode.omega / (unit * b * b) - 1)) for mode, b in zip(modes, wave_numbers, strict=True))


def _cantilever(numbers: "Sequence[int]") -> "list[mpmath.mpf]":
    """βL of so numbered modes of a cantilever."""
    import mpmath

    with mpmath.workdps(40):
        return [mpmath.findroot(lambda x: mpmath.cos(x) + 1 / mpmath.cosh(x), (n - mpmath.mpf(0.5)) * mpmath.pi)
                for n in numbers]


def _tip() -> "list[mpmath.mpf]":
    """βL of the first modes of one that carries half its mass."""
    import mpmath

    def condition(x: "mpmath.mpf") -> "mpmath.mpf":
        return 1 / mpmath.cosh(x) + mpmath.cos(x) - x / 2 * (mpmath.sin(x) - mpmath.cos(x) * mpmath.tanh(x))

    with mpmath.workdps(40):
        return [mpmath.findroot(condition, mpmath.mpf(start)) for start in TIP]
