"""Uniform plane bodies: mass centre, moment of inertia, area or length.

With R the radius, α the half angle, O the centre of a sector's or arch's circle and C the mass centre
(Kovacić & Radomirović 2018, table 1.3.1):

    disc       J_C = ½ m R²                     ring    J_C = m R²
    sector     J_O = ½ m R², OC = 2 R sin α/(3α)    arch    J_O = m R², OC = R sin α/α
    rectangle  J_C = m (a² + b²)/12             ellipse J_C = m (a² + b²)/4, semi-axes a, b
    rod        J_C = m l²/12                    particle J_C = 0
"""

from collections.abc import Callable
from typing import TYPE_CHECKING

from vibcli.base.named_tuple import NamedTuple

if TYPE_CHECKING:
    from vibcli.symbolic.expression import Table
    from vibcli.symbolic.node import Node

NEEDS = {"particle": (), "disc": ("radius",), "ring": ("radius",), "rod": ("from", "to"),
         "rectangle": ("width", "height"), "ellipse": ("a", "b"), "sector": ("radius", "half_angle"),
         "arch": ("radius", "half_angle")}


class Uniform(NamedTuple):
    """What a shape gives: the square of its radius of gyration about C, the offset OC along its axis, its measure
    (area or length; None for a particle), and the radius it rolls on (None where it is not round)."""

    gyration2: "Node"
    measure: "Node | None"
    radius: "Node | None" = None
    offset: "Node | None" = None


def _sector(table: "Table", radius: "Node", half: "Node") -> Uniform:
    offset = 2 * radius * table.call("sin", half) / (3 * half)
    return Uniform(radius * radius / 2 - offset * offset, half * radius * radius, radius, offset)


def _arch(table: "Table", radius: "Node", half: "Node") -> Uniform:
    offset = radius * table.call("sin", half) / half
    return Uniform(radius * radius - offset * offset, 2 * half * radius, radius, offset)


LAWS: dict[str, Callable[..., Uniform]] = {
    "particle": lambda table: Uniform(table.zero, None),
    "disc": lambda table, radius: Uniform(radius * radius / 2, table.pi * radius * radius, radius),
    "ring": lambda table, radius: Uniform(radius * radius, 2 * table.pi * radius, radius),
    "rod": lambda table, length: Uniform(length * length / 12, length),
    "rectangle": lambda table, width, height: Uniform((width * width + height * height) / 12, width * height),
    "ellipse": lambda table, a, b: Uniform((a * a + b * b) / 4, table.pi * a * b),
    "sector": _sector,
    "arch": _arch,
}
