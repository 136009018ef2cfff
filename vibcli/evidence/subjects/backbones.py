"""Frequencies of free motions by their amplitude."""

from math import tau
from typing import TYPE_CHECKING

import mpmath

from vibcli.base.errors import PhysicsError
from vibcli.evidence.plain_equations import plain_equations
from vibcli.evidence.reference import backbones as reference
from vibcli.evidence.reference.static_positions import equations
from vibcli.evidence.subject import Subject, of_number
from vibcli.evidence.subjects.vibrations import exact
from vibcli.mechanics.configuration import Configuration
from vibcli.quantities import equilibrium
from vibcli.quantities.expression import measure, number_of
from vibcli.quantities.quantity import about_which
from vibcli.results.motion_signals import node_of

if TYPE_CHECKING:
    from vibcli.results.problem import Problem
    from vibcli.symbolic.syntax import QuantityRef

KIND, TITLE, AHEAD = "full motion", "of the free motion with an amplitude", 2.05


def by_amplitude(problem: "Problem", tree: "QuantityRef") -> Subject:
    """backbone[1](x)(10 cm); others follow it in time over two periods."""
    omega, _ = measure(problem, tree)           # refused where there is none
    asked, which = about_which(tree)
    one = problem if which is None else equilibrium.about(problem, int(which))
    motion = reference.free_motion(one.numeric, equations(one.configuration, rests=False))
    if len(motion.scene.q) > 1:
        raise PhysicsError("no reference is found of free motions of several coordinates")
    amplitude = number_of(problem, asked.args[1])
    near = one.free_motions.turning_places(asked.args[0], amplitude)
    swing = reference.FreeSwing(motion, node_of(one, asked.args[0]), exact(one, asked.args[1]), near)
    T, motion = reference.true_period(swing), reference.from_its_turn(swing)
    with mpmath.workdps(T.working):
        true = T._replace(values=[2 * mpmath.pi / T.values[0]])
    plain = plain_equations(motion, motion.scene.v[0], AHEAD * tau / omega, "period")
    return of_number(KIND, one, tree, TITLE, true, plain._replace(
        read=lambda states, times: tau / plain.read(states, times)), float(true.values[0]),
        lambda: problem.about(Configuration(problem.numeric)))
