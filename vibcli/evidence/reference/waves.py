"""Functions of the time that are sums of sines and cosines, as phasors: f = f₀ + Σ Re P e^{iΩt}, whatever the Ω are."""

from typing import TYPE_CHECKING, Any

import mpmath

from vibcli.base.errors import PhysicsError
from vibcli.base.named_tuple import NamedTuple
from vibcli.symbolic.derivatives import gradient, substitute
from vibcli.symbolic.evaluation import evaluate, multiprecision
from vibcli.symbolic.expression_graph import reachable

if TYPE_CHECKING:
    from collections.abc import Mapping, Sequence

    from vibcli.scene.scene import Scene
    from vibcli.symbolic.node import Node

REFUSED = "a reference of steady states is found of loads that are sums of sines and cosines"


class WavesInTime(NamedTuple):
    """Sines and cosines of the time, of which `nodes` are functions with a letter for each; angles: at t = 0, and how
    fast they grow."""

    names: list[str]
    letters: list[str]
    nodes: "list[Node]"
    angles: "list[Node]"
    rates: "list[Node]"

    def phasors(self, known: "Mapping[str, Any]") -> list[tuple[Any, Any]]:
        """[(Ω, P)] of each sine and cosine as Re P e^{iΩt}, Ω ≥ 0; known: the numbers of parameters, and t = 0."""
        found = []
        for name, angle, speed in zip(self.names, *(evaluate(part, multiprecision(), known) for part in (
                self.angles, self.rates)), strict=True):
            P = mpmath.expj(angle) * (mpmath.mpc(0, -1) if name == "sin" else 1)
            found.append((abs(speed), P if speed >= 0 else mpmath.conj(P)))
        return found


def waves(nodes: "Sequence[Node]", scene: "Scene") -> WavesInTime:
    """The WavesInTime in functions of the time; PhysicsError where the time stands elsewhere."""
    time = scene.time
    calls = [part for part in reachable(nodes) if part.op == "call" and part.mask & time.mask]
    rates = [gradient(part.args[0]).get(time, scene.table.zero) for part in calls]
    letters = [scene.table.parameter(f"wave[{i}]", positive=False) for i in range(len(calls))]
    found = substitute(list(nodes), dict(zip(calls, letters, strict=True)))
    if any(part.name not in ("sin", "cos") for part in calls) or any(
            node.mask & time.mask for node in (*rates, *found)):
        raise PhysicsError(REFUSED)
    return WavesInTime([part.name for part in calls], [letter.name for letter in letters], found,
                 [part.args[0] for part in calls], rates)


def in_frequencies(found: WavesInTime,
                   known: "Mapping[str, Any]") -> tuple[list[mpmath.mpf], list[tuple[mpmath.mpf, list[mpmath.mpc]]]]:
    """([f₀], [(Ω, [P])]) of all functions; PhysicsError where one is not linear in its waves."""
    def at(values: "Sequence[mpmath.mpf]") -> "list[mpmath.mpf]":
        return evaluate(found.nodes, multiprecision(), {**known, **dict(zip(found.letters, values, strict=True))})

    count = len(found.letters)
    still = at([mpmath.mpf(0)] * count)
    slopes = [[x - y for x, y in zip(at([mpmath.mpf(i == k) for i in range(count)]), still, strict=True)]
              for k in range(count)]
    tried = [mpmath.mpf(k + 2) / (2 * k + 3) for k in range(count)]
    for x, y, parts in zip(at(tried), still, zip(*slopes, strict=True) if slopes else [()] * len(still), strict=True):
        terms = [y, *(a * b for a, b in zip(tried, parts, strict=True))]
        if abs(x - mpmath.fsum(terms)) > mpmath.mpf(10) ** (8 - mpmath.mp.dps) * max(map(abs, terms)):
            raise PhysicsError(REFUSED)
    together: dict[Any, list[Any]] = {}
    for (Omega, P), parts in zip(found.phasors(known), slopes, strict=True):
        if not Omega:
            still = [x + mpmath.re(P) * part for x, part in zip(still, parts, strict=True)]
            continue
        small = mpmath.mpf(10) ** (8 - mpmath.mp.dps) * Omega
        alike = next((other for other in together if abs(other - Omega) <= small), Omega)
        before = together.get(alike, [mpmath.mpf(0)] * len(parts))
        together[alike] = [x + P * part for x, part in zip(before, parts, strict=True)]
    return still, sorted(together.items())
