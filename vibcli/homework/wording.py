"""Words of sheets as they are set: Greek letters, signals without names of the file that the sheet does not show."""

import re
from typing import TYPE_CHECKING, Any

from vibcli.notation.as_printed import as_printed
from vibcli.notation.plain import plain
from vibcli.quantities.quantity import quantity_of
from vibcli.symbolic.syntax import NameRef

if TYPE_CHECKING:
    from collections.abc import Iterator

    from vibcli.language.reader import Record
    from vibcli.language.spec import Spec

PARTS = "stretch", "force", "power"
NAMED_BY = "k", "c", "b", "torsion"
STANDING = {"mode": ("mode i",), "number": ("family i",), "signal": ("a coordinate or signal", "a signal"),
            "time": ("an instant",), "amplitude": ("this amplitude",)}     # in what a quantity is, for what it is of


def quantity_in_words(spec: "Spec", tree: Any, text: str) -> tuple[str, bool]:
    """(what a quantity is, with the numbers and names of what it is of; do the words alone tell it?)"""
    quantity = quantity_of(spec, tree)
    if quantity is None:
        return "this expression", False
    about, put_in = re.split("[;:,]", quantity.about)[0], 0
    args = [text[arg.start - tree.start:arg.end - tree.start] for arg in tree.args]
    given_of = [*zip(quantity.indices, tree.indices, strict=False), *zip(quantity.args, args, strict=False)]
    for kind, given in given_of:
        standing = next((one for one in STANDING.get(kind, ()) if one in about), None)
        if standing is not None:
            about, put_in = about.replace(standing, _put_in(spec, kind, standing, given)), put_in + 1
    return about, put_in == len(tree.indices) + len(args) and not tree.component


def _put_in(spec: "Spec", kind: str, standing: str, given: str) -> str:
    if kind == "signal":
        return signal_in_words(spec, given)
    if kind == "amplitude":
        return f"the amplitude {as_printed(given)}"
    return given if kind == "time" else standing[:-1] + given


def signal_in_words(spec: "Spec", text: str) -> str:
    """A signal as a sheet names it: the stretch of the spring k, the force on the ground."""
    if text.isidentifier():
        return plain.symbol(text)
    name, _, part = text.partition(".")
    if text == "ground.force":
        return "the force on the ground"
    if spec.connection(name) is None or part not in PARTS:
        return text
    return f"the {part} of the {name_in_words(spec, name)}"


def name_in_words(spec: "Spec", name: str) -> str:
    """What has a name in the file, as a sheet names it: the spring k, φ; other names as they are."""
    if name in spec.coordinates:
        return plain.symbol(name)
    record = spec.connection(name)
    return name if record is None else f"{record.element.name} {next(_letters(record), name)}"


def _letters(record: "Record") -> "Iterator[str]":
    """The letter that stands beside an element in the figure."""
    for key in NAMED_BY:
        if isinstance(getattr(record.get(key), "tree", None), NameRef):
            yield plain.symbol(record[key].tree.name)
