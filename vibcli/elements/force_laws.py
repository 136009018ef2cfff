"""What the `law` of a spring or damper, or of a part of one, makes its force and energy."""

from typing import TYPE_CHECKING, Any

from vibcli.language.reader import Expression

if TYPE_CHECKING:
    from vibcli.language.reader import Record
    from vibcli.symbolic.node import Node


def force_and_energy(record: "Record", scene: Any, local: str, x: "Node",
                     name: str) -> "tuple[Node, Node] | None":
    """(F(x), ∫₀ˣ F dx), x being called `local` in the law of `name`; None where the energy is not found, which is
    reported."""
    law = record["law"]
    if isinstance(law, Expression):
        force = scene.lower(law, (local, x))
        energy = scene.integrated(force, x, law.where)
        return None if energy is None else (force, energy)
    from vibcli.symbolic.tabulated_functions import PiecewiseCubic

    arguments, forces = ([point[i].value for point in law.points] for i in range(2))
    table = PiecewiseCubic(name, arguments, forces, law.linear)
    return table.called(0, x), table.called(-1, x)
