"""Bodies whose moments of inertia are mistaken."""

from collections.abc import Iterator
from typing import TYPE_CHECKING

from vibcli.notation.scene_language import language

if TYPE_CHECKING:
    from vibcli.elements.rigid_body import Body
    from vibcli.homework.mistakes.mistake import Part
    from vibcli.results.problem import Problem
    from vibcli.symbolic.node import Node


def massive(problem: "Problem") -> "Iterator[tuple[str, Body]]":
    """(name, Body) of those in the plane that turn and have a moment of inertia of their own."""
    for name, body in problem.scene.bodies.items():
        if body.frame is not None and not body.frame.angle.is_zero and body.inertia is not None and (
                not body.inertia.is_zero) and "parts" not in body.record and body.mass is not None:
            yield name, body


def pinned_at_centre(body: "Body") -> bool:
    """Does it turn about its mass centre?"""
    return "pin" in body.record and all((c - o).is_zero for c, o in zip(body.centre, body.frame.drawn, strict=True))


def is_wheel(body: "Body") -> bool:
    """Is it round, or of no shape that is told, and turns about its mass centre?"""
    return pinned_at_centre(body) and ("shape" not in body.record or "radius" in body.record)


def without_inertia(name: str) -> "Part":
    """The part of the scene in which a body has no moment of inertia of its own."""
    return {"bodies": {name: {"inertia": "0"}}}


def with_inertia(name: str, inertia: "Node") -> "Part":
    """The part in which it has another one."""
    return {"bodies": {name: {"inertia": language(inertia)}}}
