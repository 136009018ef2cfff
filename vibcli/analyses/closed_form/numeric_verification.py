"""Closed forms against numbers: the same scene at random admissible values of its letters.

A set of values is admissible where the figure fits together and as many modes are unstable as at the first.
"""

from collections.abc import Iterable, Mapping, Sequence
from typing import TYPE_CHECKING

from vibcli.base.errors import Inertless, PhysicsError, SpecError
from vibcli.language.parameter_samples import given_values
from vibcli.symbolic.evaluation import Floats, evaluate

if TYPE_CHECKING:
    from vibcli.analyses.closed_form.closed_forms import ClosedMode
    from vibcli.analyses.modal.modal_analysis import ModalAnalysis
    from vibcli.mechanics.symbolic_system import SymbolicSystem
    from vibcli.symbolic.node import Node

WANTED, ATTEMPTS, FAILURES = 4, 24, 6
CLOSE, ROUNDING = 1e-7, 1e-10


def samples(symbolic: "SymbolicSystem", modal: "ModalAnalysis", wanted: int = WANTED) -> "list[ModalAnalysis]":
    """The modes at admissible values, the first at those by which the scene is drawn; of a scene without letters its
    own."""
    if not symbolic.numeric.has_free_symbols:
        return [modal]
    found, failures = [], 0
    for candidate in _candidates(symbolic):
        try:
            kind = _unstable(candidate) if _same_figure(symbolic, candidate) else None
        except (SpecError, PhysicsError):
            failures += 1
            if failures > FAILURES and not found:
                break
            continue
        if not found:
            first = kind
        if kind is not None and kind == first:
            found.append(candidate)
        if len(found) == wanted:
            break
    return found


def _candidates(symbolic: "SymbolicSystem") -> "Iterable[ModalAnalysis]":
    """Modes: those that reach the equilibrium found in letters, or others at random values."""
    if symbolic.equilibrium is not None:
        return symbolic.equilibrium.reached
    parameters, sample = symbolic.scene.parameters, symbolic.scene.sample
    free = [name for name in parameters.free if name not in symbolic.numeric.given]
    return (symbolic.modal_of(symbolic.configuration.with_values(given_values(parameters, sample, free, attempt)))
            for attempt in range(ATTEMPTS))


def _same_figure(symbolic: "SymbolicSystem", candidate: "ModalAnalysis") -> bool:
    """Are M, C, G, K those in letters? A rope that leaves its pulley elsewhere makes another figure."""
    for letters, numbers in zip(symbolic.matrices, candidate.configuration.linear_system.matrices(), strict=True):
        pairs = list({*letters, *numbers})
        zero = symbolic.scene.table.zero
        found = evaluate([letters.get(pair, zero) for pair in pairs], Floats, candidate.numeric.floats)
        size = max((abs(x) for x in numbers.values()), default=0.0)
        if not all(abs(x - numbers.get(pair, 0.0)) <= CLOSE * size for pair, x in zip(pairs, found, strict=True)):
            return False
    return True


def _unstable(candidate: "ModalAnalysis") -> int:
    if len(candidate.scene.q) == 1:
        return squares(candidate)[0] < 0
    return sum(mode.growth_rate is not None for mode in candidate.modes)


def squares(candidate: "ModalAnalysis") -> list[float]:
    """The numeric ω², ascending."""
    if len(candidate.scene.q) == 1:
        M, _, _, K = candidate.configuration.linear_system.matrices()
        if not M.get((0, 0)):
            raise Inertless
        return [K.get((0, 0), 0.0) / M[0, 0]]
    return sorted(-float(mode.growth_rate) ** 2 if mode.omega is None else float(mode.omega) ** 2
                  for mode in candidate.modes)


def confirmed(modes: "Sequence[ClosedMode]", polynomials: "Sequence[list[Node]]",
              candidates: "Sequence[ModalAnalysis]") -> bool:
    """Do the ω² in letters, and the roots of unsolved polynomials, equal those in numbers at every sample, and is each
    ω the positive root of its square?"""
    return all(_agree(_found(modes, polynomials, candidate), squares(candidate)) and _are_roots(modes, candidate)
               for candidate in candidates)


def _are_roots(modes: "Sequence[ClosedMode]", candidate: "ModalAnalysis") -> bool:
    values = evaluate([part for mode in modes for part in (mode.omega, mode.square)], Floats, candidate.numeric.floats)
    return all(omega >= 0 and abs(omega * omega - (-square if mode.unstable else square)) <= CLOSE * abs(square)
               for mode, omega, square in zip(modes, values[::2], values[1::2], strict=True))


def _found(modes: "Sequence[ClosedMode]", polynomials: "Sequence[list[Node]]",
           candidate: "ModalAnalysis") -> list[float]:
    return sorted([*evaluate([mode.square for mode in modes], Floats, candidate.numeric.floats),
                   *(x for polynomial in polynomials for x in roots_in_numbers(polynomial, candidate.numeric.floats))])


def roots_in_numbers(polynomial: "Sequence[Node]", values: Mapping[str, float]) -> list[float]:
    """The real parts of the roots of a polynomial with coefficients from the highest."""
    import numpy as np

    found: list[float] = np.roots(evaluate(polynomial, Floats, values)).real.tolist()
    return found


def _agree(found: Sequence[float], wanted: Sequence[float]) -> bool:
    largest = max(map(abs, wanted), default=0.0)
    return len(found) == len(wanted) and all(
        abs(a - b) <= CLOSE * max(abs(b), 1e-4 * largest) for a, b in zip(found, wanted, strict=True))


def shape_confirmed(mode: "ClosedMode", amplitudes: "Sequence[Node]", candidates: "Sequence[ModalAnalysis]") -> bool:
    """Is (K − ω²M + iωG) x = 0 at every sample? Where the mode turns, x₂ is a quarter period ahead."""
    return all(_balanced(mode, amplitudes, candidate) for candidate in candidates)


def _balanced(mode: "ClosedMode", amplitudes: "Sequence[Node]", candidate: "ModalAnalysis") -> bool:
    square, = evaluate([mode.square], Floats, candidate.numeric.floats)
    omega = abs(square) ** 0.5
    x = evaluate(amplitudes, Floats, {**candidate.numeric.floats, "ω": omega})
    x = [value * (1j if mode.turns and i else 1) for i, value in enumerate(x)]
    M, _, G, K = candidate.configuration.linear_system.matrices()
    n, none = len(x), 0.0
    size = [(abs(K.get((i, i), none)) + abs(square * M.get((i, i), none))) ** 0.5 for i in range(n)]
    rounding = ROUNDING * sum(s * abs(value) for s, value in zip(size, x, strict=True))
    for i in range(n):
        terms = [part * x[j] for j in range(n) for part in (
            K.get((i, j), none), -square * M.get((i, j), none), 1j * omega * G.get((i, j), none))]
        if not abs(sum(terms)) <= CLOSE * sum(map(abs, terms)) + rounding * size[i]:
            return False
    return True


def damping_confirmed(modes: "Sequence[ClosedMode]", candidates: "Sequence[ModalAnalysis]") -> bool:
    """Do ω and ζ in letters equal those in numbers, where the modes are under-damped, at every sample?"""
    return all(_damping_agrees(modes, candidate) for candidate in candidates)


def _damping_agrees(modes: "Sequence[ClosedMode]", candidate: "ModalAnalysis") -> bool:
    zetas = evaluate([mode.zeta for mode in modes], Floats, candidate.numeric.floats)
    if len(candidate.scene.q) == 1:
        M, C, _, K = (matrix.get((0, 0), 0.0) for matrix in candidate.configuration.linear_system.matrices())
        square, omega_d = K / M - C * C / (4 * M * M), evaluate([modes[0].omega_d], Floats, candidate.numeric.floats)[0]
        result: bool = abs(zetas[0] ** 2 * 4 * K * M - C * C) <= CLOSE * C * C and (
                    square <= 0 or abs(omega_d * omega_d - square) <= CLOSE * K / M)
        return result
    omegas = evaluate([mode.omega for mode in modes], Floats, candidate.numeric.floats)
    if any(zeta >= 1 for zeta in zetas):
        return True
    found = sorted(omega * zeta for omega, zeta in zip(omegas, zetas, strict=True))
    return _agree(found, sorted(float(mode.decay) for mode in candidate.damped if mode.omega and mode.zeta))
