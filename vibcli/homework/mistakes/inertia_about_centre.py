"""The moment of inertia about the mass centre for that about the pin: J_C for J_C + m d²."""

from typing import TYPE_CHECKING

from vibcli.homework.mistakes.bodies import massive, pinned_at_centre
from vibcli.homework.mistakes.mistake import CommonMistake
from vibcli.notation.scene_language import language
from vibcli.symbolic.syntax import NameRef

if TYPE_CHECKING:
    from collections.abc import Iterator

    from vibcli.homework.mistakes.mistake import Part
    from vibcli.results.problem import Problem


def _changed(problem: "Problem") -> "Iterator[tuple[str, Part]]":
    written = (problem.spec.get("energies") or {}).get("T")
    for name, body in massive(problem):
        pin = body.record.get("pin")
        if pin and "carrier" not in pin and isinstance(pin["by"].tree, NameRef) and not pinned_at_centre(body):
            dx, dy = (c - o for c, o in zip(body.centre, body.frame.drawn, strict=True))
            lost = language(body.mass * (dx * dx + dy * dy))
            kept = f"({written.text}) " if written is not None else ""
            yield name, {"energies": {"T": f"{kept}-({lost})*{pin['by'].tree.name}'^2/2"}}


MISTAKE = CommonMistake("this takes the moment of inertia about the mass centre for that about the pin", model=_changed)
