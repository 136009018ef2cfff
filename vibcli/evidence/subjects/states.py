"""Mass and stiffness matrices and generalised forces at an instant of a motion, by its equations M q̈ + h(q, q̇, t) = 0:

    M,      Q = −h(q, 0, t),      K = ∂h/∂q (q, 0, t), by a central difference.
"""

from fractions import Fraction
from typing import TYPE_CHECKING

from vibcli.base.errors import PhysicsError
from vibcli.evidence.reference.motion import at_instant
from vibcli.evidence.subject import Subject, of_signal
from vibcli.evidence.subjects.motions import KINDS, compared_with, followed, instant
from vibcli.mechanics.equations_of_motion import dynamics
from vibcli.quantities.expression import measure
from vibcli.quantities.matrices import coordinate_number
from vibcli.symbolic.derivatives import gradient, substitute

if TYPE_CHECKING:
    from vibcli.results.problem import Problem
    from vibcli.scene.scene import Scene
    from vibcli.symbolic.node import Node
    from vibcli.symbolic.syntax import QuantityRef

STEP = Fraction(1, 10**20)


def of_state(problem: "Problem", tree: "QuantityRef") -> Subject:
    """M[x,y](2 s), K[x,y](2 s) or Q[x](2 s)."""
    scene = problem.scene
    if scene.loops is not None or tree.head == "C" or (tree.head != "M" and _damps_when_still(scene)):
        raise PhysicsError("of states of a motion no reference is found of C, where loops are closed, or of forces "
                           "that hang on velocities at rest")
    measure(problem, tree)          # refused where there is none
    kind, motion = followed(problem)
    node, plain = (substitute([one], {q: motion.coordinate(q.name) for q in scene.q})[0] for one in _nodes(
        problem, tree.head, *(coordinate_number(problem, name) for name in tree.indices)))
    until = instant(problem, tree.args[0])
    true = at_instant(motion, node, until, problem.work)
    return of_signal(KINDS[kind], problem, tree, f"of {problem.response.words}", true,
                     compared_with(problem, motion, plain, until, "value"))


def _damps_when_still(scene: "Scene") -> bool:
    """May what damps, or a load, hang on velocities where all coordinates are at rest?"""
    damps = scene.dampers or any(law.damper for law in scene.laws)
    return bool(scene.timed and damps) or any(
        load.weight.mask & v.mask for load in scene.forces for v in scene.v)


def _nodes(problem: "Problem", head: str, i: int, j: int | None = None) -> "tuple[Node, Node]":
    """(what the reference evaluates, what others do)."""
    scene = problem.scene
    parts, zero = dynamics(scene, scene.freedom.redundant), scene.table.zero
    if head == "M":
        entry = parts.M.get((min(i, j), max(i, j)), zero)
        return entry, entry
    h, = substitute([parts.h[i]], dict.fromkeys(scene.v, zero))
    if head == "Q":
        return -h, -h
    q, step = scene.q[j], scene.table.number(STEP)
    up, down = (substitute([h], {q: q + way * step})[0] for way in (1, -1))
    return (up - down) / (2 * step), gradient(h).get(q, zero)
