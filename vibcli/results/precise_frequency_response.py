"""H(iΩ) = cᵀ D⁻¹ b + d, D = K + s C + s² M, s = iΩ, to any number of digits from the exact data; and where |H| turns,
passes a level, has a pole or vanishes, by Newton's method from the place that the floats find.

With x = D⁻¹ b its rates by s follow from D x′ = b′ − D′ x and D x″ = b″ − 2 D′ x′ − D″ x.
"""

from collections.abc import Callable, Iterable, Mapping
from typing import TYPE_CHECKING, Any

import mpmath
from mpmath import mp

from vibcli.base.errors import LostDigits, PhysicsError
from vibcli.mechanics.inputs_outputs.inputs import direct_part, in_powers, named_input
from vibcli.mechanics.inputs_outputs.outputs import linear_row
from vibcli.mechanics.precise_configuration import PreciseConfiguration
from vibcli.results.precise_signals import agreed
from vibcli.results.precise_work import MOST, require_quick

if TYPE_CHECKING:
    from vibcli.results.precise_member_response import PreciseMemberCurve
    from vibcli.results.problem import Problem

PRICE = 4e-5        # steps of a million products, of a complex elimination of one coordinate, by n³
STEPS, LOST, FAR = 30, 8, 1e-3      # of Newton's method; digits that its last step may lack; how far it may go
TURN, POLE, ZERO, LEVEL = "turn", "pole", "zero", "level"


class PreciseCurve:
    """H of a signal to a unit of an input, at the working precision."""

    def __init__(self, problem: "Problem", signal: str, driver: str) -> None:
        configuration = PreciseConfiguration(problem.configuration)
        row, chosen = linear_row(configuration, signal), named_input(configuration, driver)
        if chosen.carried:
            raise PhysicsError("more digits of a response to a load that turns with what is driven are not found",
                               "leave --digits out")
        self.n, (M, C, G, K) = len(problem.scene.coordinates), configuration.matrices
        self.M, self.C, self.K = self._matrix(M), self._matrix(C) + self._matrix(G), self._matrix(K)
        b = in_powers(configuration.with_inputs.columns, chosen.weights, chosen.turns)
        self.b, self.c = self._columns(b), self._columns((row.q, row.v, row.a))
        self.d = [mp.mpmathify(x) for x in direct_part(row, chosen)]

    def _matrix(self, entries: Mapping[tuple[int, int], float]) -> mpmath.matrix:
        found = mp.matrix(self.n, self.n)
        for (i, j), x in entries.items():
            found[i, j] = x
        return found

    def _columns(self, parts: Iterable[Mapping[int, Any]]) -> list[mpmath.matrix]:
        return [mp.matrix([mp.mpmathify(part.get(i, 0)) for i in range(self.n)]) for part in parts]

    def at(self, Omega: "mpmath.mpf", order: int = 0) -> "list[mpmath.mpc]":
        """[H, dH/dΩ, d²H/dΩ²] up to an order."""
        s = mp.mpc(0, Omega)
        D, slope = self.K + s * self.C + s * s * self.M, self.C + 2 * s * self.M
        b, c, d = ([part[0] + s * (part[1] + s * part[2]), part[1] + 2 * s * part[2], 2 * part[2]]
                   for part in (self.b, self.c, self.d))
        x = [self._solved(D, b[0])]
        if order:
            x.append(self._solved(D, b[1] - slope * x[0]))
        if order > 1:
            x.append(self._solved(D, b[2] - 2 * slope * x[1] - 2 * self.M * x[0]))
        H = [_dot(c[0], x[0]) + d[0]]
        if order:
            H.append(mp.j * (_dot(c[1], x[0]) + _dot(c[0], x[1]) + d[1]))
        if order > 1:
            H.append(-(_dot(c[2], x[0]) + 2 * _dot(c[1], x[1]) + _dot(c[0], x[2]) + d[2]))
        return H

    def _solved(self, D: mpmath.matrix, right: mpmath.matrix) -> mpmath.matrix:
        try:
            return mp.lu_solve(D, right)
        except ZeroDivisionError:
            raise PhysicsError("the input drives an undamped mode at its natural frequency",
                               "ask at another frequency") from None

    def place(self, near: float, kind: str, level: Any = 0) -> "mpmath.mpf":
        """Ω near one in floats at which |H| turns, H has a pole or a zero, or |H|² is a level."""
        Omega = mp.mpf(near)
        for _ in range(STEPS):
            step = self._step(Omega, kind, level)
            Omega += step
            if abs(Omega - near) > FAR * near:
                break
            if abs(step) <= mp.mpf(10) ** (LOST - mp.dps) * Omega:
                return Omega
        raise PhysicsError(f"more digits of what lies at Ω = {near:.12g} rad/s are not found", "leave --digits out")

    def _step(self, Omega: mpmath.mpf, kind: str, level: float) -> mpmath.mpf:
        H, *rates = self.at(Omega, 2 if kind == TURN else 1)
        if kind == POLE:            # of 1/H
            return mp.re(H / rates[0])
        if kind == ZERO:
            return -mp.re(H / rates[0])
        slope = mp.re(mp.conj(H) * rates[0])            # half that of |H|²
        if kind != TURN:
            return (level - abs(H) ** 2) / (2 * slope)
        return -slope / (abs(rates[0]) ** 2 + mp.re(mp.conj(H) * rates[1]))


def _dot(one: Iterable[mpmath.mpc], two: Iterable[mpmath.mpc]) -> mpmath.mpc:
    return mp.fsum(x * y for x, y in zip(one, two, strict=True))


def precise_response(problem: "Problem", signal: str, driver: str, omega: "Callable[[], mpmath.mpf]", digits: int,
                     most: float = MOST) -> "mpmath.mpc":
    """H to so many digits of |H|; omega: gives Ω at the working precision."""
    require_quick(PRICE * len(problem.scene.coordinates) ** 3, digits, problem.work, most)
    try:
        size = abs(problem.frequency_response(signal, driver).at(float(omega()))[0])
    except LostDigits:          # near places on a member, of which floats do not tell even the size
        size = 0.0

    def parts() -> "list[mpmath.mpf]":
        H, = _curve(problem, signal, driver).at(omega())
        return [mp.re(H), mp.im(H)]

    re, im = agreed(parts, digits, size)
    return mpmath.mpc(re, im)


def precise_place(problem: "Problem", signal: str, driver: str, read: "Callable[[PreciseCurve], mpmath.mpf]",
                  digits: int, most: float = MOST) -> "mpmath.mpf":
    """A number that `read` finds on the curve, to so many digits."""
    if problem.configuration.linear_system.pieces:
        raise PhysicsError("more digits of what is read off a frequency response of members are not found",
                           "leave --digits out, or ask for the response at a frequency")
    require_quick(STEPS * PRICE * len(problem.scene.coordinates) ** 3, digits, problem.work, most)
    return agreed(lambda: [read(PreciseCurve(problem, signal, driver))], digits)[0]


def _curve(problem: "Problem", signal: str, driver: str) -> "PreciseCurve | PreciseMemberCurve":
    if not problem.configuration.linear_system.pieces:
        return PreciseCurve(problem, signal, driver)
    from vibcli.results.precise_member_response import PreciseMemberCurve

    return PreciseMemberCurve(problem, signal, driver)
