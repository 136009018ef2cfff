"""Harmonics of the steady state under a load that repeats itself: of a signal X_n = cᵀ (K + s C + s² M)⁻¹ b_n + d_n,
s = inΩ, with the Fourier coefficients of the loads by quadrature between the instants at which they bend or jump:

    b_n = (2/T) ∫ Q(t) e^{−inΩt} dt,   T = 2π/Ω.
"""

from collections.abc import Sequence
from typing import TYPE_CHECKING, Any

import mpmath

from vibcli.base.errors import PhysicsError
from vibcli.evidence.reference.frequency_response import Transfer, at
from vibcli.evidence.reference.motion import Motion
from vibcli.evidence.reference.settled import DIGITS, TrueValues, settled
from vibcli.evidence.reference.steady_state import TRIED, HarmonicLoads, rate, response
from vibcli.symbolic.derivatives import gradient, substitute
from vibcli.symbolic.evaluation import evaluate, multiprecision
from vibcli.symbolic.expression_graph import reachable

if TYPE_CHECKING:
    from vibcli.symbolic.node import Node

WAVES, BENT = ("sin", "cos", "square", "sawtooth"), ("abs", "sign", "min", "max")


def repeated(motion: Motion) -> "tuple[HarmonicLoads, list[Node]]":
    """(the loads, the angles of their waves) of a small motion; PhysicsError of others than waves of angles that grow
    evenly."""
    scene = motion.scene
    loads = [-node for node in substitute(motion.parts.h, dict.fromkeys((*scene.q, *scene.v), scene.table.zero))]
    called = [part for part in reachable(loads) if part.mask & scene.time.mask and part.op == "call"]
    angles = [part.args[0] for part in called if part.name in WAVES]
    rates = [gradient(angle).get(scene.time) for angle in angles]
    if not angles or any(part.name not in WAVES + BENT for part in called) or any(
            one is None or one.mask for one in rates):
        raise PhysicsError("a reference of harmonics is found of loads that are made of sines, squares and saw teeth")
    return HarmonicLoads(motion, loads, rates), angles


def transfer(loads: "tuple[HarmonicLoads, list[Node]]", node: "Node", number: int) -> tuple[Transfer, Any]:
    """(the response of a linear signal to harmonic n of all loads, nΩ) at the working precision."""
    known, angles = loads
    numbers, Omega = rate(known)
    scene, period, arithmetic = known.motion.scene, 2 * mpmath.pi / Omega, multiprecision()
    starts = evaluate(angles, arithmetic, {**numbers, scene.time.name: mpmath.mpf(0)})
    ends = sorted({0, period, *(part * period for start in starts for part in _bends(start / (2 * mpmath.pi)))})

    def phasors(nodes: "Sequence[Node]") -> "list[mpmath.mpc | mpmath.mpf]":
        return [mpmath.mpf(0) if not node.mask & scene.time.mask else 2 / period * mpmath.quad(
            lambda t, node=node: evaluate([node], arithmetic, {**numbers, scene.time.name: t})[0] * mpmath.expj(
                -number * Omega * t), ends) for node in nodes]

    return response(known, node, phasors), number * Omega


def _bends(turned: mpmath.mpf) -> list[mpmath.mpf]:
    """Parts of a period at which an angle that begins at so many turns is a whole number of half ones."""
    return [mpmath.fmod(k / mpmath.mpf(2) - turned, 1) % 1 for k in range(2)]


def harmonic(loads: "tuple[HarmonicLoads, list[Node]]", node: "Node", number: int) -> TrueValues:
    """Its amplitude |X_n|, 0 where rounding is all that is left of it; about: that of the first harmonic."""
    def found() -> "tuple[list[mpmath.mpf], mpmath.mpf]":
        fundamental = transfer(loads, node, 1)
        if not max(map(abs, fundamental[0].b[0])) > mpmath.mpf(10) ** (10 - mpmath.mp.dps) * _size(loads[0]):
            raise PhysicsError("this load may repeat itself within the period of its waves: no reference is found")
        size, first = (abs(at(*one)[0]) for one in (transfer(loads, node, number), fundamental))
        return [size if size > mpmath.mpf(10) ** (10 - mpmath.mp.dps) * first else mpmath.mpf(0)], max(first, size)

    return settled(found, DIGITS, sized=True)


def _size(known: HarmonicLoads) -> mpmath.mpf:
    """The largest of some values of the loads."""
    numbers, Omega = rate(known)
    return max(abs(x) for part in TRIED for x in evaluate(known.loads, multiprecision(), {
        **numbers, known.motion.scene.time.name: 2 * mpmath.pi / Omega * mpmath.mpf(part)}))
