"""Bodies as built, and what the motion of each refers to."""

from collections.abc import Mapping
from typing import TYPE_CHECKING

from vibcli.base.named_tuple import NamedTuple
from vibcli.elements import ELEMENTS

if TYPE_CHECKING:
    from collections.abc import Sequence

    from vibcli.language.reader import Record, Reference
    from vibcli.language.spec import Spec
    from vibcli.scene.places import Frame
    from vibcli.symbolic.node import Node

MOTIONS = tuple(name for name, (section, _) in ELEMENTS.items() if section is None and not name.endswith("_part"))


class Body(NamedTuple):
    """A body as built: mass centre as drawn, mass and J_C (nodes), frame, or its lumped motion.

    pieces: (mass, centre, J_C) of the welded parts where T is the sum of theirs, else None. cut: the same of parts some
    of which are holes, with negative mass, from which J_C follows. rims: the centres as drawn
    of its round shapes, and rolling_radius their radius, None of none or several. normal: the unit vector from the
    surface that it rolls or slides on to the body, or to the left of the direction in which it slides; reach: from the
    first of two contacts to the centre, along it.
    """

    name: str
    record: "Record"
    mass: "Node | None" = None
    inertia: "Node | None" = None
    centre: "tuple[Node, Node] | None" = None
    pieces: "list[tuple[Node, tuple[Node, Node], Node]] | None" = None
    cut: "list[tuple[Node, tuple[Node, Node], Node]] | None" = None
    rims: "Sequence[tuple[Node, Node]]" = ()
    rolling_radius: "Node | None" = None
    frame: "Frame | None" = None
    lumped: "tuple[str, Node] | None" = None
    normal: "tuple[Node, Node] | None" = None
    reach: "Node | None" = None

    @property
    def moves(self) -> bool:
        """Has it a motion of its own?"""
        return any(key in self.record for key in MOTIONS)

    @property
    def touched(self) -> list[str]:
        """Names of the surfaces that it rolls or slides on."""
        return [reference.text for reference in touched(self.record)]

    @property
    def nodes(self) -> "list[Node]":
        """The expressions of the coordinates that it is made of."""
        frame = self.frame.nodes if self.frame is not None else []
        return [*frame, *(self.lumped or ())[1:], *(self.normal or ())]

    def over(self, new: "Mapping[Node, Node]") -> "Body":
        """Itself with its expressions replaced, {node: node}."""
        return self._replace(frame=self.frame and self.frame.over(new),
                             lumped=self.lumped and (self.lumped[0], new[self.lumped[1]]),
                             normal=self.normal and (new[self.normal[0]], new[self.normal[1]]))


def touched(record: "Record") -> "list[Reference]":
    """References to the surfaces that a body of this record rolls or slides on."""
    motion = next((record[key] for key in ("roll", "slide") if key in record), {})
    return [motion["surface"]] if "surface" in motion else list(motion.get("between", ()))


def carriers(record: "Record", spec: "Spec") -> list[str]:
    """Names of the bodies that the motion of a body of this record refers to."""
    names = [record["weld"].text] if "weld" in record else []
    motion = next((record[key] for key in MOTIONS if key in record and key != "weld"), {})
    names += [motion[key].text for key in ("carrier", "at") if hasattr(motion.get(key), "text")]
    carried = [spec.get("surfaces")[reference.text] for reference in touched(record)]
    names += [surface["body"].text for surface in carried if "body" in surface]
    points = spec.get("points") or {}
    bodies = [points[n]["body"].text if n in points and "body" in points[n] else n for n in names]
    found = [n for n in bodies if n not in points]
    if any(n in (spec.get("member_points") or {}) for n in found):
        from vibcli.elements.member_fields import bodies_that_hold

        return [body for n in found for body in bodies_that_hold(n, spec)]
    return found
