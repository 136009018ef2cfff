"""Names of members: what their motions measure, which are coordinates without being named."""

from typing import TYPE_CHECKING

from vibcli.base import units
from vibcli.elements.member_places import motions_of
from vibcli.language.member_signals import start_mistake
from vibcli.language.sections.initial import FIELDS

if TYPE_CHECKING:
    from vibcli.language.reader import Reader
    from vibcli.language.spec import Spec


def name_motions(spec: "Spec", reader: "Reader") -> None:
    """The dimensions of their displacements and angles, and mistakes of fields with which they start."""
    for name, angle in motions_of(spec):
        spec.dimensions.equate(spec.dimensions.unknown(name), units.NONE if angle else units.LENGTH)
    for name in spec.members:
        for part, measured in (("u", units.LENGTH), ("phi", units.NONE)):
            spec.dimensions.equate(spec.dimensions.unknown(f"{name}.{part}"), measured)
    for signal in spec.get(FIELDS) or ():
        found = start_mistake(spec, signal)
        if found is not None:
            reader.report(spec.get("initial").place(signal.text), *found)
