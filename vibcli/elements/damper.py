"""Dampers between two ends: Φ = ½ c ḋ², the integral of a law, or R |ḋ| of dry friction, d being their distance."""

from typing import TYPE_CHECKING

from vibcli.elements import ends
from vibcli.elements.torsion import Torsion, settle_torsion
from vibcli.language.fields import Element, Field
from vibcli.language.kinds import ENDS, Many, Quantity
from vibcli.language.named_elements import Lazy, LazyKind
from vibcli.symbolic.rationals import HALF

if TYPE_CHECKING:
    from vibcli.language.reader import Reader, Record
    from vibcli.scene.builder import Builder
    from vibcli.symbolic.node import Node

PARTS = "series", "parallel"


def _settle(record: "Record", reader: "Reader") -> None:
    if any(key in record for key in PARTS):
        from vibcli.elements.series import settle_parts

        settle_parts(record, reader)
    settle_torsion(record, reader, ("law", "friction", "breakaway"), "v", rate=True)
    if "breakaway" in record and "friction" not in record:
        reader.report(record.place("breakaway"), "'breakaway' goes with 'friction'", "write `friction:` too")


ELEMENT = Element(
    "damper",
    "A damper between two ends: its force is c times the rate at which they part, what its `law` says, or dry friction "
    "of a given size, which sticks at rest. `torsion` turns between two bodies; `stretch` gives its deflection "
    "outright.",
    {
        "c": Field(Quantity("N*s/m"), "its coefficient, force per speed"),
        "torsion": Field(Torsion("N*m*s"), "its torsional coefficient, moment per angular speed; `true` beside a law "
                         "or friction"),
        "law": Field(LazyKind("law_table", "language.sections"),
                     "its force as a function of the rate v of its length, as in c*v*abs(v) (v means this only inside "
                     "a law), or a table: points, or {table: a file or points, columns: [1, 2], units: [m/s, N], "
                     "beyond: linear}"),
        "friction": Field(Quantity(), "the size of its dry friction, as in mu*N, which acts against the "
                              "motion; at rest it is what holds, up to that size"),
        "breakaway": Field(Quantity(), "the largest friction at rest, where it is more than `friction`"),
        "series": Field(Many(Lazy("damper_part"), 2, named="a list of two parts or more"),
                        "its parts one behind the other, which share the force: [{c: c1}, {c: c2}]"),
        "parallel": Field(Many(Lazy("damper_part"), 2, named="a list of two parts or more"),
                          "its parts side by side, which share the deflection; nested in `series` or alone"),
        "between": Field(ENDS, "its two ends [A, B]"),
        "stretch": Field(Quantity(), "its deflection as an expression of the coordinates, instead of two ends"),
    },
    exclusive=(("c", "torsion"), ("c", "law", *PARTS), ("friction", *PARTS), ("between", "stretch")),
    needs=(("c", "torsion", "law", "friction", *PARTS), ("between", "stretch")),
    settle=_settle,
    example="mass_spring_damper",
    instead={"damping": "did you mean 'c'?", "ct": "did you mean 'torsion'?", "mu": "did you mean 'friction'?"},
    signals={"stretch": ("m", "rad"), "force": ("N", "N*m"), "power": ("W", "W")},
)


def build(record: "Record", scene: "Builder") -> None:
    """Add the dissipation function of a damper to the scene."""
    torsion = record.get("torsion")
    if any(key in record for key in PARTS):
        _build_parts(record, scene)
        return
    given = record.get("c", torsion)
    c = None if given in (None, True) else scene.lower(given)
    stretch = ends.stretch(record, scene, torsion is not None)
    if stretch is None:
        return
    if "law" not in record and "friction" not in record:
        scene.add_damper(c, stretch)
        return
    v = scene.table.variable("the rate")
    energy = scene.table.zero if c is None else c * v * v * HALF
    if "law" in record:
        from vibcli.elements.force_laws import force_and_energy

        found = force_and_energy(record, scene, "v", v, record.name)
        if found is None:
            return
        energy = energy + found[1]
    bound = None
    if "friction" in record:
        friction = scene.positive(record["friction"], "the friction")
        energy = energy + friction * scene.table.call("abs", v)
        bound = _bound(record, scene, friction)
    scene.add_law(stretch, v, energy, damper=True, bound=bound)


def _build_parts(record: "Record", scene: "Builder") -> None:
    """Parts in series or in parallel, whose rates add up."""
    from vibcli.elements.composition import composed, stiffness

    v = scene.table.variable("the rate")
    part, stretch = composed(record, scene, v, record.name), ends.stretch(record, scene, "torsion" in record)
    if part is None or stretch is None:
        return
    c = stiffness(part, v)
    if c is not None:
        scene.add_damper(c, stretch)
    else:
        scene.add_law(stretch, v, part.energy, damper=True)


def _bound(record: "Record", scene: "Builder", friction: "Node") -> "Node":
    """The largest friction at rest over that in motion."""
    if "breakaway" not in record:
        return scene.table.one
    breakaway = scene.positive(record["breakaway"], "the friction at rest")
    if scene.number(breakaway) < scene.number(friction):
        scene.report(record["breakaway"].where, "the friction at rest is less than that in motion",
                     "leave `breakaway` out where both are the same")
    return breakaway / friction
