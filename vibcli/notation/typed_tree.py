"""What was typed, set in a typeset notation by its syntax: fractions, roots, powers, Greek letters, units in words."""

from typing import Any

from vibcli.notation.as_printed import as_printed
from vibcli.notation.typeset import KNOWN, Stacked
from vibcli.symbolic.syntax import Call, NameRef, Number, Power, Product, Sum, UnitPower


def typeset(tree: Any, text: str, write: Stacked) -> str:
    """The tree of a text in a notation; a part of it that is no formula of numbers and names stands as words."""
    if isinstance(tree, Number):
        return _number(tree, text, write)
    if isinstance(tree, NameRef):
        return write.symbol(tree.name + "'" * tree.primes)
    if isinstance(tree, Sum):
        return write.added([(sign < 0, _bracketed(part, text, write, isinstance(part, Sum)))
                            for sign, part in tree.parts])
    if isinstance(tree, Product):
        above, below = (_side(tree, sign, text, write) for sign in (1, -1))
        return write.fraction(above, below) if below else above
    if isinstance(tree, Power):
        loose = isinstance(tree.base, (Sum, Product, Power)) or bool(getattr(tree.base, "units", ()))
        base = _call(tree.base, text, write, False) if isinstance(tree.base, Call) else _bracketed(
            tree.base, text, write, loose)
        return write.power(base, typeset(tree.exponent, text, write))
    if isinstance(tree, Call):
        return _call(tree, text, write)
    return write.words(as_printed(text[tree.start:tree.end]))


def _number(tree: Any, text: str, write: Stacked) -> str:
    """A literal as it was typed, 0.50 as 0.50, its unit behind it."""
    end = tree.units[0].start if tree.units else tree.end
    unit = as_printed(text[tree.start:tree.end])[len(as_printed(text[tree.start:end])):] if tree.units else ""
    return write.beside(write.numeral(text[tree.start:end].strip()), write.words(unit))


def _bracketed(tree: Any, text: str, write: Stacked, needed: bool | tuple[UnitPower, ...]) -> str:
    found = typeset(tree, text, write)
    return write.brackets(found) if needed else found


def _side(product: Product, sign: int, text: str, write: Stacked) -> str:
    """The factors above or below the line of a product: numbers side by side have dots between them."""
    parts = [part for power, part in product.parts if power == sign]
    if len(parts) < 2:
        return typeset(parts[0], text, write) if parts else write.numeral("1") * (sign > 0)
    dotted = write.with_values({"": ""}) if any(map(_begins_with_figure, parts[1:])) else write
    return dotted.multiplied([
        _bracketed(part, text, write, isinstance(part, Sum) or (part is not parts[-1] and getattr(part, "units", ())))
        for part in parts])


def _begins_with_figure(tree: Any) -> bool:
    """Would it, right behind a figure, be read as one number with that?"""
    while isinstance(tree, (Power, Product)):
        tree = tree.base if isinstance(tree, Power) else tree.parts[0][1]
    return isinstance(tree, Number)


def _call(tree: Any, text: str, write: Stacked, may_be_bare: bool = True) -> str:
    inner = [typeset(arg, text, write) for arg in tree.args]
    if tree.name == "sqrt":
        return write.sqrt(*inner)
    if tree.name == "abs":
        return write.magnitude(*inner)
    name, bare = KNOWN.get(tree.name, tree.name), may_be_bare and isinstance(tree.args[0], NameRef)
    if len(inner) > 1:
        return write.function(name, inner)
    return write.applied(write.functional(name), inner[0] if bare else write.brackets(inner[0]), bare)
