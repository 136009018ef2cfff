"""Viscous dampers between two ends: Φ = ½ c ḋ², d being the distance of the ends."""

from vibcli import units
from vibcli.fields import ENDS, Element, Field, Quantity


def _settle(record, reader):
    if "stretch" in record:
        record["stretch"].dimension = units.NONE if "torsion" in record else units.LENGTH


ELEMENT = Element(
    "damper",
    "A viscous damper between two ends: its force is c times the rate at which they part. `torsion` turns between two "
    "bodies; `stretch` gives its deflection outright.",
    {
        "c": Field(Quantity("N*s/m"), "its coefficient, force per speed"),
        "torsion": Field(Quantity("N*m*s"), "its torsional coefficient, moment per angular speed"),
        "between": Field(ENDS, "its two ends [A, B]"),
        "stretch": Field(Quantity(), "its deflection as an expression of the coordinates, instead of two ends"),
    },
    exclusive=(("c", "torsion"), ("between", "stretch")),
    needs=(("c", "torsion"), ("between", "stretch")),
    settle=_settle,
    instead={"law": "a nonlinear law does not work yet", "series": "c: c1*c2/(c1 + c2)",
             "parallel": "write two dampers with the same ends, or c: c1 + c2"},
    example="mass_spring_damper",
)


def build(record, scene):
    """Add the dissipation function of a damper to the scene."""
    torsion = "torsion" in record
    c = scene.lower(record["torsion" if torsion else "c"])
    stretch = scene.stretch(record, torsion)
    if stretch is not None:
        scene.add_damper(c, stretch)
