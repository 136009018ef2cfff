"""Units of literals as letters: 0.3 m is 0.3 times the letter of a metre, which is 1, so that formulas keep it through
all algebra. Their names are their values as they are typed."""

from typing import TYPE_CHECKING

from vibcli.language.document.document import Scalar
from vibcli.language.reader import Expression, Record
from vibcli.symbolic.node import UNITS
from vibcli.symbolic.parser import parse

if TYPE_CHECKING:
    from vibcli.language.spec import Spec


def with_unit_letters(spec: "Spec") -> "Spec":
    """The Spec whose parameters have the letters of units among them, with which its expressions are then lowered."""
    parameters = dict(spec.parameters)
    for base, name in UNITS.items():
        scalar = Scalar(name, None)
        parameters[name] = Record(None, name, None, {"value": Expression(scalar, parse(name))}, {})
        spec.dimensions.equate(spec.dimensions.unknown(name), {base: 1})
    return spec.with_parameters(parameters)
