"""Quantities of springs, dampers and bodies: has the element what is asked, a law of this letter, a mass or a place?"""

from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from vibcli.base.errors import Where
    from vibcli.language.reader import Reader
    from vibcli.language.spec import Spec
    from vibcli.symbolic.syntax import QuantityRef

PLACED, MASSIVE = {"at", "from", "parts"}, {"mass", "density", "parts"}     # keys of bodies that are, one of each


def has_what_is_asked(spec: "Spec", reader: "Reader", where: "Where", tree: "QuantityRef") -> bool:
    """Has the element a law of this letter, a mass, or a place? Reports what is wrong."""
    head, indices, bodies = tree.head, tree.indices, spec.get("bodies") or {}
    if head == "law" and len(indices) == 2 and indices[1][0] != (letter := law_letter(spec, indices[0])):
        reader.report(where, f"the law of '{indices[0]}' is a function of {letter}",
                      f"write law[{indices[0]}, {letter}{indices[1][1:]}]")
        return False
    lumped = [name for name in indices if name in bodies and not PLACED & set(bodies[name].places)]
    if lumped and (head == "centre" or (head == "J" and len(indices) == 2)):
        reader.report(where, f"'{lumped[0]}' has no place", "say where it is drawn with `at: [x, y]`")
        return False
    if head == "mass" and not MASSIVE & set(bodies[indices[0]].places):
        turns = "inertia" in bodies[indices[0]].places
        reader.report(where, f"'{indices[0]}' has no mass", "give it `mass: m`"
                      + f", or ask for J[{indices[0]}], its moment of inertia" * turns)
        return False
    return True


def law_letter(spec: "Spec", name: str) -> str:
    """What a law is a function of: the deflection d of a spring, the rate v of a damper."""
    return "v" if name in (spec.get("dampers") or {}) else "d"
