"""Where a scene rests: coordinates, places, stretches and forces of springs in an equilibrium."""

from typing import TYPE_CHECKING

import mpmath

from vibcli.base.errors import PhysicsError
from vibcli.evidence.reference.static_positions import equations, true_position
from vibcli.evidence.subject import MethodAnswer, Subject
from vibcli.mechanics.configuration import Configuration
from vibcli.quantities import equilibrium
from vibcli.quantities.expression import measure
from vibcli.quantities.modal import counted
from vibcli.quantities.quantity import about_which, declared
from vibcli.results.random_states import reach
from vibcli.symbolic.derivatives import substitute
from vibcli.symbolic.syntax import QuantityRef

if TYPE_CHECKING:
    from vibcli.results.problem import Problem

NOTHING = 1e-6      # of a reach: what is nearer to zero is measured by that


def at_rest(problem: "Problem", tree: QuantityRef) -> Subject:
    """A coordinate or signal in equilibrium; the others begin half a reach away, that of random states, from there."""
    asked, number = about_which(tree)
    one = problem if number is None else equilibrium.about(problem, int(number))
    static = equations(one)
    scene = static.scene
    node = equilibrium.at_rest(one, scene, problem.spec.coordinate_name(asked.indices[0]) or asked.indices[0])
    if node is None:
        raise PhysicsError("of what rests a reference is found of places, stretches and forces of springs alone")
    node, = substitute([node], dict.fromkeys((*scene.v, scene.time), scene.table.zero))
    size = declared(asked).size(one, asked)
    true = true_position(one, static, node, size)
    scale = max(abs(float(true.values[0])), NOTHING * size) or 1.0
    start = [x + 0.5 * reach(one, name) for x, name in zip(static.near, scene.coordinates, strict=False)]

    def ours() -> MethodAnswer:
        value, bound = measure(problem.about(Configuration(problem.numeric)), tree)
        return MethodAnswer([value], bound * abs(value) / scale)

    def error(found, known):
        with mpmath.workdps(known.working):
            return float(abs(mpmath.mpf(float(found[0])) - known.values[0]) / scale)

    return Subject("static position", tree.text, f"at rest, {counted(len(static.names), 'equation')}", one, true, ours,
                   (static, node, start + static.near[len(start):]), error, scale)
