"""Cross-sections of members, and what they give: area, second moments, the distance of the outer fibre.

    circle d        A = π d²/4            I = π d⁴/64            I_o = π d⁴/32
    tube [D, d]     A = π (D² − d²)/4     I = π (D⁴ − d⁴)/64     I_o = π (D⁴ − d⁴)/32
    rectangle [b, h]  A = b h             I = b h³/12, h in the plane of bending; I_o is not its torsion constant
"""

from typing import TYPE_CHECKING

from vibcli.base.named_tuple import NamedTuple
from vibcli.language.fields import Element, Field
from vibcli.language.kinds import Many, Quantity

if TYPE_CHECKING:
    from vibcli.language.reader import Record
    from vibcli.scene.builder import Builder
    from vibcli.symbolic.node import Node

SECTION = Element(
    "section",
    "The cross-section of a member: `{circle: d}` and `{tube: [D, d]}` with diameters, `{rectangle: [b, h]}` with h in "
    "the plane of bending.",
    {
        "circle": Field(Quantity("m"), "its diameter"),
        "tube": Field(Many(Quantity("m"), 2, 2, "two diameters [D, d]"), "outer and inner diameter [D, d]"),
        "rectangle": Field(Many(Quantity("m"), 2, 2, "width and height [b, h]"), "width and height [b, h], the "
                           "height in the plane of bending"),
    },
    exclusive=(("circle", "tube", "rectangle"),),
    needs=(("circle", "tube", "rectangle"),),
    example="beams",
)


class CrossSection(NamedTuple):
    """Area A, second moments I and I_o (None of a rectangle), distance of the outer fibre from the axis, depth in the
    plane of bending."""

    A: "Node"
    I: "Node"      # noqa: E741
    Io: "Node | None"
    fibre: "Node"
    depth: "Node"


def cross_section(record: "Record", scene: "Builder") -> CrossSection:
    """That of a record; sizes that are not positive are reported."""
    if "rectangle" in record:
        b, h = (scene.positive(size, what) for size, what in zip(record["rectangle"], ("the width", "the height"),
                                                                 strict=True))
        return CrossSection(b * h, b * h**3 / 12, None, h / 2, h)
    if "circle" in record:
        outer, inner = scene.positive(record["circle"], "the diameter"), scene.table.zero
    else:
        outer = scene.positive(record["tube"][0], "the outer diameter")
        inner = scene.positive(record["tube"][1], "the inner diameter", zero=True)
        if scene.number(inner) >= scene.number(outer):
            scene.report(record["tube"][1].where, "the inner diameter is not less than the outer one",
                         "write [outer, inner]")
    pi = scene.table.pi
    fourth = pi * (outer**4 - inner**4)
    return CrossSection(pi * (outer**2 - inner**2) / 4, fourth / 64, fourth / 32, outer / 2, outer)
