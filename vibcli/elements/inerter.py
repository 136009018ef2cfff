"""Inerters between two ends (Smith 2002): T = ½ b ṡ², s being the stretch; the force is b s̈."""

from typing import TYPE_CHECKING

from vibcli.elements import ends
from vibcli.elements.torsion import settle_torsion
from vibcli.language.fields import Element, Field
from vibcli.language.kinds import ENDS, Quantity

if TYPE_CHECKING:
    from vibcli.language.reader import Reader, Record
    from vibcli.scene.builder import Builder


def _settle(record: "Record", reader: "Reader") -> None:
    settle_torsion(record, reader, (), "s", rate=True)


ELEMENT = Element(
    "inerter",
    "An inerter between two ends: its force is b times the acceleration with which they part, as of a flywheel that a "
    "rack turns; it has no weight. `torsion` acts between the rotations of two bodies; `stretch` gives its stretch "
    "outright.",
    {
        "b": Field(Quantity("kg"), "its inertance, force per acceleration; of a flywheel of moment of inertia J that a "
                   "pinion of radius r turns, J/r^2"),
        "torsion": Field(Quantity("kg*m^2"), "its torsional inertance, moment per angular acceleration"),
        "between": Field(ENDS, "its two ends [A, B]; the stretch grows as B leaves A"),
        "stretch": Field(Quantity(), "its stretch as an expression of the coordinates, instead of two ends"),
    },
    exclusive=(("b", "torsion"), ("between", "stretch")),
    needs=(("b", "torsion"), ("between", "stretch")),
    settle=_settle,
    instead={"series": "b: b1*b2/(b1 + b2)", "parallel": "write two inerters with the same ends, or b: b1 + b2",
             "mass": "b: its inertance"},
    example="inerters",
    signals={"stretch": ("m", "rad"), "force": ("N", "N*m")},
)


def build(record: "Record", scene: "Builder") -> None:
    """Add the kinetic energy of an inerter to the scene."""
    torsion = "torsion" in record
    b = scene.positive(record["torsion" if torsion else "b"], f"the inertance of '{record.name}'")
    stretch = ends.stretch(record, scene, torsion)
    if stretch is not None:
        scene.add_inerter(b, stretch)
