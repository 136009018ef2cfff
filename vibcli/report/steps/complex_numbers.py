"""Complex numbers and expressions a + i·b as lines tell them."""

from typing import TYPE_CHECKING, Any

from vibcli.report.blocks import Factor, Name
from vibcli.report.steps.step import told

if TYPE_CHECKING:
    from collections.abc import Sequence

    from vibcli.symbolic.node import Node

SMALL = 1e-12       # of a part beside the other: rounding


def complex_parts(real: "Node", imaginary: "Node") -> list[Any]:
    """Parts of a + i·b."""
    if imaginary.is_zero:
        return [real]
    negative = imaginary.op != "sum" and imaginary.coefficient < 0
    sign = "−" if negative else ""
    head = [] if real.is_zero else [real]
    if head:
        sign = f" {sign or '+'} "
    return [*head, f"{sign}i·", Factor(-imaginary if negative else imaginary)]


def complex_told(value: complex) -> str:
    """a + b·i as mathematics."""
    real, imaginary = cleared(value).real, cleared(value).imag
    if not imaginary:
        return told(real)
    if not real:
        return f"{told(imaginary)}·i"
    return f"{told(real)} {'−' if imaginary < 0 else '+'} {told(abs(imaginary))}·i"


def factor_told(value: complex) -> str:
    """The same before a dot: in brackets where it is a sum or negative."""
    text = complex_told(value)
    return f"({text})" if " " in text or text.startswith("−") else text


def shape_told(names: "Sequence[str]", shape: Any) -> list[Any]:
    """Parts of x : y = 1 : (2 + 3·i)."""
    return [*[part for name in names for part in (" : ", Name(name))][1:], " = " + " : ".join(
        f"({told})" if " " in (told := complex_told(complex(x))) else told for x in shape)]


def cleared(value: complex) -> complex:
    """A complex number without what rounding leaves of a part beside the other."""
    size = SMALL * abs(value)
    return complex(*(0.0 if abs(part) <= size else part for part in (value.real, value.imag)))
