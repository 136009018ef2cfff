"""What the `law` of a spring or damper, or of a part of one, makes its force and energy."""

from math import isfinite
from typing import TYPE_CHECKING

from vibcli.language.reader import Expression
from vibcli.symbolic.derivatives import substitute

if TYPE_CHECKING:
    from vibcli.language.reader import Record
    from vibcli.scene.builder import Builder
    from vibcli.symbolic.node import Node


def force_and_energy(record: "Record", scene: "Builder", local: str, x: "Node",
                     name: str) -> "tuple[Node, Node] | None":
    """(F(x), ∫₀ˣ F dx), x being called `local` in the law of `name`; None where the energy is not found, which is
    reported."""
    law = record["law"]
    if isinstance(law, Expression):
        force = scene.lower(law, (local, x))
        energy = _energy(force, scene, x, name)
        if energy is None:
            scene.report(law.where, f"the energy of this law is not found: it has no finite force at {local} = 0",
                         "write it so that it has one there; other energies stand under `energies`")
        return None if energy is None else (force, energy)
    from vibcli.symbolic.tabulated_functions import PiecewiseCubic

    arguments, forces = ([point[i].value for point in law.points] for i in range(2))
    table = PiecewiseCubic(name, arguments, forces, law.linear)
    return table.called(0, x), table.called(-1, x)


def _energy(force: "Node", scene: "Builder", x: "Node", name: str) -> "Node | None":
    """∫₀ˣ F dx by rules, else by quadrature where F is finite at 0; None of others."""
    from vibcli.symbolic.antiderivatives import from_zero

    found = from_zero(force, x)
    if found is not None:
        return found
    from vibcli.symbolic.integrals_of_laws import by_quadrature

    try:
        finite = isfinite(scene.number(*substitute([force], {x: x.table.zero})))
    except ZeroDivisionError:
        finite = False
    return by_quadrature(name + ".integral", force, x) if finite else None
