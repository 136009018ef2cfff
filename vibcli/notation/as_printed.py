"""A value as it was typed, 40 N*s/m, as it is set in print: 40 N·s/m, 30°, 9.81 m/s², √(2)·π·f₁."""

from collections.abc import Collection

from vibcli.notation.plain import plain
from vibcli.notation.typed_values import set_in_print


def as_printed(text: str, names: Collection[str] = ()) -> str:
    """The text with its signs as they are printed; `names`: those of the scene, letters of the field among them."""
    return set_in_print(text, plain.symbol, {"pi", *names})
