"""An undamped degree of freedom driven at its natural frequency: M ẍ + K x = A sin ωt + B cos ωt + F, from which

    x = (B sin ωt − A cos ωt) t/(2 M ω) + F/K + a cos ωt + b sin ωt,   a = x(0) − F/K,  b = (ẋ(0) + A/(2 M ω))/ω.
"""

from collections.abc import Mapping
from typing import TYPE_CHECKING

from vibcli.base.errors import PhysicsError
from vibcli.mechanics.initial_state import start_in_letters
from vibcli.report.blocks import Name, Words
from vibcli.report.steps.degree import Degree
from vibcli.symbolic.derivatives import substitute

if TYPE_CHECKING:
    from vibcli.symbolic.node import Node


ROUNDED = 1e-12     # relative: of K and M ω² of numbers that are given with all digits of floats


def is_resonance(degree: Degree, argument: "Node") -> bool:
    """Does nothing damp, and is Ω the natural frequency?"""
    square = degree.problem.scene.rate(argument) ** 2
    return degree.C.is_zero and degree.about.cancel([degree.K, -(degree.M * square)], ROUNDED)


def tell_growing(degree: Degree, argument: "Node", parts: "Mapping[str, Node]") -> "tuple[Node, Node, int]":
    """Write down what a load at the natural frequency makes grow: it, its rate at t = 0, the number of the line."""
    about, scene, sheet = degree.about, degree.problem.scene, degree.sheet
    omega, zero = scene.rate(argument), about.table.zero
    A, B = (about.tidy(parts.get(kind, zero) / (2 * degree.M * omega)) for kind in ("sin", "cos"))
    factor = B * about.table.call("sin", argument) - A * about.table.call("cos", argument)
    line = sheet.write(Words(f"to {' and '.join(parts)} of "), argument, Words(
        ", which swings at the natural frequency, belongs what grows with the time, as the equation shows,  "),
        Name(degree.name), " = ", scene.time * factor, settles="resonance", node=scene.time * factor,
        uses=degree.found.lines)
    return scene.time * factor, substitute([factor], {scene.time: zero})[0], line


def tell_resonance(degree: Degree, argument: "Node", parts: "Mapping[str, Node]") -> None:
    """The motion under a load at the natural frequency alone, and its constants from the start."""
    about, scene, sheet = degree.about, degree.problem.scene, degree.sheet
    grows, speed, line = tell_growing(degree, argument, parts)
    try:
        x0, v0 = start_in_letters(degree.problem.symbolic) or (about.table.zero,) * 2
    except PhysicsError:
        return
    omega = scene.rate(argument)
    sine, cosine = (about.table.call(kind, omega * scene.time) for kind in ("sin", "cos"))
    load = degree.found.drive[0]
    mean = about.tidy((load - scene.terms_with(load, scene.time.mask)) / degree.K)
    whole = grows + mean + about.tidy(x0 - mean) * cosine + about.tidy((v0 - speed) / omega) * sine
    sheet.write(Words("with a free motion, from the start  "), Name(degree.name), " = ", x0, Words(",  "),
                Name(degree.name + "'"), " = ", v0, Words(":  "), Name(degree.name), " = ", whole,
                settles="motion from the start", node=whole, uses=[line])
