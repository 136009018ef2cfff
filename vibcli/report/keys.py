"""Keys of --json, each said once, beside the section that finds it: what it means, and what gives its value.

    Key("unit", "its unit")                              what was found has it under this name
    Key("unit", "its unit", lambda one: one.dimension)   a function of what was found gives it
    Key("modes", "a list …", each=(Key(…), …))           a list of objects with these keys; `of`: one such object
"""

from collections.abc import Iterator, Mapping, Sequence
from typing import TYPE_CHECKING, Any

from vibcli.base.named_tuple import NamedTuple

if TYPE_CHECKING:
    from vibcli.analyses.modal.damped_modes import DampedMode
    from vibcli.analyses.modal.energy_shares import Shares
    from vibcli.results.problem import Problem


class Key(NamedTuple):
    """A key of an object of the JSON."""

    name: str
    about: str
    value: Any = None
    each: tuple[Any, ...] = ()
    of: tuple[Any, ...] = ()

    def row(self, *values: Any) -> dict[str, Any]:
        """{name: value} of an object, or of an entry of the list."""
        return dict(zip([key.name for key in self.each or self.of], values, strict=True))


def documented(keys: Sequence[Key], path: str = "") -> Iterator[tuple[str, str]]:
    """(path, what it means) of all keys: dots lead into objects, [] into lists."""
    for key in keys:
        yield path + key.name, key.about
        yield from documented(key.of, f"{path}{key.name}.")
        yield from documented(key.each, f"{path}{key.name}[].")


def data(keys: Sequence[Key], found: "Mapping[str, Any] | tuple[DampedMode, dict[str, float]] | Shares | Problem",
         digits: int | None = None) -> dict[str, Any]:
    """{name: value} of what was found, null where there is nothing; numbers of mpmath as texts of so many digits."""
    return {key.name: _value(key, found, digits) for key in keys}


def _value(key: Key, found: "Mapping[str, Any] | tuple[DampedMode, dict[str, float]] | Shares | Problem",
           digits: int | None) -> Any:
    if key.value is not None:
        value = key.value(found)
    else:
        value = found[key.name] if isinstance(found, dict) else getattr(found, key.name)
    if value is None or not (key.of or key.each):
        return plain(value, digits)
    return data(key.of, value, digits) if key.of else [data(key.each, one, digits) for one in value]


def plain(value: Any, digits: Any = None) -> Any:
    """A value as JSON has it: an expression as a text of the language, a complex number as [re, im]."""
    if value is None or isinstance(value, (str, bool, int, float)):
        return value
    if isinstance(value, dict):
        return {name: plain(one, digits) for name, one in value.items()}
    if isinstance(value, (list, tuple)):
        return [plain(one, digits) for one in value]
    if hasattr(value, "table"):
        from vibcli.notation.scene_language import language

        return language(value)
    if value.imag:
        return [plain(value.real, digits), plain(value.imag, digits)]
    if digits is None:
        return float(value.real)
    import mpmath

    return mpmath.nstr(mpmath.mpf(value.real), digits, strip_zeros=False) if value else "0"
