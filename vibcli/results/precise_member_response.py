"""H(iΩ) of scenes with members to any number of digits: D(s) X = load with the exact stiffness of every piece."""

from collections.abc import Sequence
from typing import TYPE_CHECKING, Any, cast

from mpmath import mp

from vibcli.analyses.continuous.spread_drives import spread_inputs
from vibcli.analyses.frequency_response.member_places import seen_at
from vibcli.analyses.frequency_response.member_system import MemberOutput
from vibcli.base.errors import PhysicsError
from vibcli.language.signal_names import signal_name
from vibcli.mechanics.given_damping import given_numbers
from vibcli.mechanics.inputs_outputs.inputs import drives_supports, named_input
from vibcli.mechanics.inputs_outputs.outputs import linear_row
from vibcli.mechanics.inputs_outputs.place_signals import place_output
from vibcli.mechanics.precise_configuration import PreciseConfiguration
from vibcli.numerics.pieces.retardation import retarded_reaction
from vibcli.numerics.pieces.stiffness import dynamic_stiffness, stiffness
from vibcli.symbolic.evaluation import multiprecision

if TYPE_CHECKING:
    import mpmath
    import numpy as np

    from vibcli.mechanics.factored_system import PlacedPiece
    from vibcli.results.problem import Problem


class PreciseMemberCurve:
    """H of a signal to a unit of an input, at the working precision."""

    def __init__(self, problem: "Problem", signal: str, driver: str) -> None:
        configuration = PreciseConfiguration(problem.configuration)
        damping = problem.modal.member_damping
        if damping is not None and not damping.whole:
            raise PhysicsError("more digits of a response of members are found of damping that is `proportional` alone",
                               "leave --digits out, or write `proportional: [alpha, beta]`")
        self.damping = None if damping is None else given_numbers(problem.configuration, multiprecision())
        opened, self.given = configuration.with_inputs, named_input(configuration, driver)
        if self.given.carried:
            raise PhysicsError("more digits of a response to a load that turns with what is driven are not found",
                               "leave --digits out")
        self.elements, self.spread = opened.elements, spread_inputs(configuration, self.given.weights)
        self.supports = drives_supports(configuration, self.given)
        self.driven, self.n = range(opened.n, len(opened.scene.q)), len(opened.scene.q)
        self.pieces, self.rates = list(self.elements.pieces), 0
        place = place_output(configuration, signal)
        if place is None:
            row = linear_row(configuration, signal_name(signal).text)
            self.output = MemberOutput((row.q, row.v, row.a))
        else:
            self.rates = place.primes
            self.pieces, self.n, self.output = seen_at(place, self.pieces, self.n, mp.mpf)

    def at(self, Omega: "mpmath.mpf") -> "list[mpmath.mpc]":
        """[H]."""
        s = mp.mpc(0, Omega)
        sigma, factor = self._undamped(s)
        return [factor * x for x in self._answer(s, sigma)]

    def _undamped(self, s: "mpmath.mpc") -> "tuple[mpmath.mpc, int | mpmath.mpc]":
        """(σ, factor): H(s) is the factor times what it is at σ without `damping:`, in displacements."""
        if self.damping is None:
            return s, 1
        alpha, beta = self.damping["proportional"]
        slope = 1 + beta * s
        return mp.sqrt(s * (s + alpha) / slope), 1 if self.supports else 1 / slope

    def _answer(self, s: "mpmath.mpc", sigma: "mpmath.mpc") -> "list[mpmath.mpc]":
        """H where stiffnesses are those at σ, and rates those of e^{st}."""
        d = [_stiffness(placed, sigma) for placed in self.pieces]
        D, free = self._matrix(sigma, d), [i for i in range(self.n) if i not in self.driven]
        put = [(number, j, drive.end_loads(placed, sigma)) for j, drive in self.spread.items()
               for number, placed in enumerate(self.pieces) if drive.on(placed) is not None]
        for number, j, loads in put:
            for row, load in zip(self.pieces[number].rows, loads, strict=True):
                for i, x in row.items():
                    D[i, j] -= x * load
        power = (-s * s) ** self.given.turns
        X = [mp.mpc(0)] * self.n
        for j in self.driven:
            X[j] = mp.mpmathify(self.given.weights.get(j, 0)) * power
        side = mp.matrix([-mp.fsum(D[i, j] * X[j] for j in self.driven) for i in free])
        try:
            found = mp.lu_solve(mp.matrix([[D[i, j] for j in free] for i in free]), side) if free else []
        except ZeroDivisionError:
            raise PhysicsError("the input drives an undamped mode at its natural frequency",
                               "ask at another frequency") from None
        for i, x in zip(free, found, strict=True):
            X[i] = x
        loaded = mp.fsum(factor * loads[end] * X[j] / (1 + self.pieces[piece].retardation * s)
                         for factor, piece, end in self.output.ends for number, j, loads in put if number == piece)
        return [(self._seen(X, s, d) - loaded) * s**self.rates]

    def _seen(self, X: "Sequence[mpmath.mpc | mpmath.mpf]", s: "mpmath.mpc", d: "Sequence[np.ndarray]") -> "mpmath.mpc":
        total = mp.fsum(mp.mpmathify(x) * s**power * X[i]
                        for power, row in enumerate(self.output.rows) for i, x in row.items())
        for factor, number, end in self.output.ends:
            for b, row in enumerate(self.pieces[number].rows):
                moved = mp.fsum(x * X[i] for i, x in row.items())
                total += factor * d[number][end, b] * moved / (1 + self.pieces[number].retardation * s)
        return total

    def _matrix(self, s: "mpmath.mpc", d: "Sequence[np.ndarray]") -> "mpmath.matrix":
        """D with the inputs among its coordinates."""
        elements, D = self.elements, mp.matrix(self.n, self.n)
        rows: list[Any] = [*elements.springs, *((s * w, row) for w, row in elements.dampers),
                                        *((s * s * w, row) for w, row in elements.inertias)]
        for weight, row in rows:
            for i, x in row.items():
                for j, y in row.items():
                    D[i, j] += weight * x * y
        for factor, entries in ((1, elements.K), (s, elements.C), (s, elements.G), (s, elements.drag),
                                (s * s, elements.M)):
            for pair, x in entries.items():
                D[pair] += factor * x
        for placed, own in zip(self.pieces, d, strict=True):
            for a, one in enumerate(placed.rows):
                for b, two in enumerate(placed.rows):
                    for i, x in one.items():
                        for j, y in two.items():
                            D[i, j] += x * y * own[a, b]
        return D


def _stiffness(placed: "PlacedPiece", s: "mpmath.mpc") -> "np.ndarray":
    """d(s), with what stiffness resists rates by."""
    beta = placed.retardation
    if not beta:
        return dynamic_stiffness(placed.piece, s)
    return cast("np.ndarray", (1 + beta * s) * stiffness(placed.piece, retarded_reaction(placed.piece, s, beta)))
