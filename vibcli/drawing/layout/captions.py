"""What is written beside an element: the quantity that the file gives it, else its name."""

import re
from collections.abc import Sequence
from typing import TYPE_CHECKING

from vibcli.drawing.layout import lettering
from vibcli.symbolic.semantics import lower
from vibcli.symbolic.syntax import NameRef

if TYPE_CHECKING:
    from vibcli.drawing.canvas.primitives import Run
    from vibcli.drawing.layout.sketch import Sketch
    from vibcli.language.reader import Expression, Record
    from vibcli.scene.scene import Scene
    from vibcli.symbolic.node import Node

SHORT = 14
RAISED = str.maketrans("0123456789-", "⁰¹²³⁴⁵⁶⁷⁸⁹⁻")


def quantity(record: "Record", keys: Sequence[str], sketch: "Sketch") -> "tuple[Run, ...]":
    """The runs that name an element by the first of some fields that it has."""
    for key in keys:
        if key in record and hasattr(record[key], "tree"):
            return expression(record[key], sketch) or lettering.named(record.name)
    return lettering.named(record.name)


def expression(field: "Expression", sketch: "Sketch", longest: int = SHORT) -> "tuple[Run, ...] | None":
    """The runs of a field: its one name, its number as written, or the expression where it is short; else None."""
    text = field.text.strip()
    if isinstance(field.tree, NameRef):
        return lettering.named(field.tree.name + "'" * field.tree.primes)
    node = raw(field, sketch.scene)
    if node.op == "number" or not any(letter.isalpha() for letter in text):
        return lettering.words(as_printed(text)) if len(text) <= longest else None
    from vibcli.drawing.layout.formulas import written

    runs = written(node)
    return runs if len(lettering.letters(runs)) <= longest else None


def as_printed(text: str) -> str:
    """A number with its unit, raised digits and dots of products as in print: m/s^2 is m/s²."""
    return re.sub(r"\^(-?\d+)", lambda power: power[1].translate(RAISED), text).replace("*", "·")


def raw(field: "Expression", scene: "Scene") -> "Node":
    """The node of a field in the letters that it is written in, dependent coordinates included."""
    def symbol(name: str, primes: int, tree: NameRef) -> "Node":
        return scene.parameters.nodes.get(name) or scene.table.variable(name + "'" * primes)

    return lower(field.tree, scene.table, symbol)


def mass(record: "Record", sketch: "Sketch") -> "tuple[Run, ...] | None":
    """The runs for a body: its mass or inertia, else its name; None of a massless one."""
    for key in ("mass", "inertia", "density"):
        if key in record and not raw(record[key], sketch.scene).is_zero:
            return quantity(record, (key,), sketch)
    return lettering.named(record.name) if "parts" in record else None
