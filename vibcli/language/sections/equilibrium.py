"""A starting place for the search of the equilibrium, where several exist."""

from typing import TYPE_CHECKING, Any

from vibcli.language.document.document import Mapping
from vibcli.language.kinds import Kind, Many, NameOf, Quantity
from vibcli.language.named_elements import Named
from vibcli.language.sections.initial import PLACE
from vibcli.language.signal_names import signal_name
from vibcli.symbolic.parser import plain_name

if TYPE_CHECKING:
    from vibcli.language.document.nodes import DocumentNode
    from vibcli.language.reader import Expression, Reader
    from vibcli.language.signal_names import SignalName


class ByCoordinate(Kind):
    """A mapping from coordinates of the scene to expressions that are measured as they are, or to lists of them.
    `scaled`: but for one factor, which is the same along all; members deflect then as functions of the place x."""

    def __init__(self, kind: Many | Quantity, wants: str, scaled: bool = False) -> None:
        self.wants, self.named, self.scaled = wants, Named(kind, wants), scaled

    def read(self, node: Any, reader: Any) -> Any:
        fields = self._fields(node, reader)
        others = Mapping(node.where, {key: pair for key, pair in node.entries.items() if key not in fields}
                         ) if fields else node
        for key, _ in others.entries.values() if isinstance(others, Mapping) else ():
            NameOf("the name of a coordinate", "coordinates").read(key, reader)
        found = self.named.read(others, reader)
        factor = f"factor of line {node.where.line}, {node.where.column}" if self.scaled else None
        for name, value in (found or {}).items():
            for expression in value if isinstance(value, list) else [value]:
                reader.along[expression.scalar] = name, factor
        for signal, expression in filter(None, fields.values()):
            reader.name_within(expression, PLACE, "m")
            reader.along[expression.scalar] = signal.text, factor
            found = {**(found or {}), signal.text: expression}
        return found

    def _fields(self, node: "DocumentNode",
                reader: "Reader") -> "dict[str, tuple[SignalName, Expression] | None]":
        """{key: (SignalName, expression of x)} of the members that deflect as functions of the place, None of what is
        reported."""
        found: dict[str, tuple[SignalName, Expression] | None] = {}
        for key, (key_node, value) in node.entries.items() if self.scaled and isinstance(node, Mapping) else ():
            signal = signal_name(plain_name(key_node.text))
            if signal.name not in reader.members:
                continue
            found[key] = None
            if signal.part not in ("u", "phi") or signal.place or signal.primes:
                reader.report(key_node.where, f"members deflect as functions of x in a shape, found '{signal.text}'",
                              f"write {signal.name}.u: x^2, of shafts {signal.name}.phi: x")
                continue
            expression = Quantity().read(value, reader)
            if expression is not None:
                found[key] = signal, expression
        return found

    def schema(self) -> dict[str, Any]:
        return self.named.schema()


KIND = ByCoordinate(Quantity(), "a mapping from coordinates to values")
ABOUT = ("Which equilibrium is meant: the one nearest to this place, stable or not, as in `{x: 1 m}`; coordinates that "
         "are left out count as drawn. Distances are those of the coordinates, lengths divided by the size of the "
         "figure. The report says how far it lies from there.")
