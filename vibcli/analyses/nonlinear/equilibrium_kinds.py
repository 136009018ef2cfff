"""Of what kind an equilibrium is in the phase plane of one degree of freedom.

By the eigenvalues of the linearised motion, λ² − a_v λ − a_q = 0 with a = q̈(q, q̇): a saddle where a_q > 0, else a focus
where a_v² + 4 a_q < 0, a node where it is positive; a centre where a_v = 0 and motions run backwards as well
(Kovačić & Radomirović 2018; Guckenheimer & Holmes 1983). Where they decide nothing, by what the forces do on both sides
of it, and on the way round it.
"""

import cmath
import math
from typing import TYPE_CHECKING

import numpy as np

from vibcli.base.named_tuple import NamedTuple

if TYPE_CHECKING:
    from vibcli.analyses.nonlinear.state_field import StateField

CENTRE, SADDLE, FOCUS, NODE, CUSP, BOTH = "centre", "saddle", "focus", "node", "cusp", "saddle-node"
LINE = "line of rest"   # a range of places at each of which it rests
STABLE, UNSTABLE = "stable", "unstable"
ZERO = 1e-12            # of its parts: what is left of a difference or sum is rounding
ROUND = 256             # places on the way round
LOST = 1e-12            # of the energy of a turn: less is rounding
WIDE = 10.0             # of where the forces beside it are known: how wide a turn is looked at


class StateEquilibrium(NamedTuple):
    """q, its kind, the eigenvalues λ [1/s] ascending by their real parts (None where the forces bend there);
    `degenerate`: do terms beyond the linear ones decide? span: of a line of rest, its ends, q being its middle."""

    q: float
    kind: str
    eigenvalues: tuple[complex, complex] | None
    degenerate: bool = False
    span: tuple[float, float] | None = None

    @property
    def attracts(self) -> bool:
        """Does every orbit near it end, or begin, in it?"""
        return self.kind.endswith((FOCUS, NODE)) and self.kind != BOTH

    @property
    def is_top(self) -> bool:
        """Do separatrices of a conservative scene end in it?"""
        return self.kind in (SADDLE, CUSP)


class Around(NamedTuple):
    """What is known of the neighbourhood: a at rest so far (`reach`) on the left and on the right of it, where no other
    equilibrium is between; reversible: do motions run backwards as they run forwards, as where energy is kept?"""

    left: float
    right: float
    reach: float
    reversible: bool


def kind_of(field: "StateField", q: float, around: Around, flat: bool, bent: bool) -> StateEquilibrium:
    """The equilibrium at q; `flat`: has it no linear stiffness; `bent`: do the forces bend there?"""
    if bent:
        return StateEquilibrium(q, _beyond(field, q, around, None), None, True)
    a_q, a_v = field.slopes(q)
    a_q, a_v = 0.0 if flat else a_q, 0.0 if around.reversible else a_v
    found = _eigenvalues(a_q, a_v)
    if a_q > 0:
        return StateEquilibrium(q, SADDLE, found)
    if a_q == 0 or abs(a_v) <= ZERO * math.sqrt(-a_q):
        kind = CENTRE if a_q < 0 and around.reversible else _beyond(field, q, around, a_v if a_q == 0 else None)
        return StateEquilibrium(q, kind, found, not (a_q < 0 and around.reversible))
    sense = STABLE if a_v < 0 else UNSTABLE
    under = a_v * a_v + 4 * a_q
    if abs(under) <= 8 * ZERO * a_v * a_v:
        return StateEquilibrium(q, f"{sense} degenerate {NODE}", (complex(a_v / 2),) * 2)
    return StateEquilibrium(q, f"{sense} {FOCUS if under < 0 else NODE}", found)


def line_of_rest(field: "StateField", low: float, high: float) -> StateEquilibrium:
    """All places from one to another."""
    middle = 0.5 * (low + high)
    return StateEquilibrium(middle, LINE, _eigenvalues(0.0, field.slopes(middle)[1]), True, (low, high))


def _eigenvalues(a_q: float, a_v: float) -> tuple[complex, complex]:
    """The roots of λ² − a_v λ − a_q, the smaller one of two real ones without a difference."""
    root = cmath.sqrt(a_v * a_v + 4 * a_q)
    if root.imag:
        return complex(a_v / 2, -root.imag / 2), complex(a_v / 2, root.imag / 2)
    large = 0.5 * (a_v + math.copysign(root.real, a_v))
    other = -a_q / large if large else 0.0
    low, high = sorted((large + 0.0, other + 0.0))
    return complex(low), complex(high)


def _beyond(field: "StateField", q: float, around: Around, a_v: float | None) -> str:
    """By the forces beside it; a_v: the damping where that alone is linear."""
    if around.left < 0 < around.right:
        return SADDLE
    if not around.left > 0 > around.right:
        return BOTH if a_v else CUSP
    if around.reversible:
        return CENTRE
    if a_v:
        return f"{STABLE if a_v < 0 else UNSTABLE} {NODE}"
    lost = _lost_in_a_turn(field, q, around)
    if abs(lost) <= LOST:
        return f"{CENTRE} or {FOCUS}"
    winds = all(low.imag for low, _ in beside(field, q, around))
    return f"{STABLE if lost < 0 else UNSTABLE} {FOCUS if winds else NODE}"


def beside(field: "StateField", q: float, around: Around) -> list[tuple[complex, complex]]:
    """The eigenvalues by the forces on the left of an equilibrium, and by those on the right."""
    speed = around.reach * math.sqrt(max(abs(around.left), abs(around.right)) / around.reach)
    found = []
    for side, a in ((-1, around.left), (1, around.right)):
        there = field.acceleration(np.full(2, q + side * around.reach), np.array([speed, -speed]))
        found.append(_eigenvalues(side * a / around.reach, float(there[0] - there[1]) / (2 * speed)))
    return found


def _lost_in_a_turn(field: "StateField", q: float, around: Around) -> float:
    """∮ (a(q, q̇) − a(q, 0)) q̇ dt round it over the energy, nearly; forces that are even in q̇ do no work there."""
    reach = WIDE * around.reach
    omega = math.sqrt(max(abs(around.left), abs(around.right)) / around.reach)
    angle = (np.arange(ROUND) + 0.5) * math.tau / ROUND
    x, v = q + reach * np.cos(angle), -reach * omega * np.sin(angle)
    work = (field.acceleration(x, v) - field.acceleration(x, 0 * v)) * v
    return float(work.mean() * math.tau / omega / (omega * reach) ** 2)
