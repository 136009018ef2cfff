"""Energies written out: what no element says."""

from typing import TYPE_CHECKING

from vibcli.language.fields import Element, Field
from vibcli.language.kinds import Quantity

if TYPE_CHECKING:
    from vibcli.language.reader import Record
    from vibcli.scene.builder import Builder

ELEMENT = Element(
    "set of energies",
    "Terms added to the kinetic energy T, the potential energy V and the dissipation function Phi, as expressions of "
    "the coordinates (`x`) and velocities (`x'`).",
    {
        "T": Field(Quantity("J"), "kinetic energy"),
        "V": Field(Quantity("J"), "potential energy, of the coordinates alone"),
        "Phi": Field(Quantity("W"), "dissipation function: half the dissipated power of linear dampers"),
    },
    example="u_tube",
)


def build(record: "Record", scene: "Builder") -> None:
    for key in ("T", "V", "Phi"):
        if key in record:
            scene.add_energy(key, scene.lower(record[key]))
