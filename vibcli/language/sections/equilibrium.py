"""A starting place for the search of the equilibrium, where several exist."""

from typing import Any

from vibcli.language.document.document import Mapping
from vibcli.language.kinds import Kind, Many, NameOf, Quantity
from vibcli.language.named_elements import Named


class ByCoordinate(Kind):
    """A mapping from coordinates of the scene to expressions that are measured as they are, or to lists of them.
    `scaled`: but for one factor, which is the same along all."""

    def __init__(self, kind: Many | Quantity, wants: str, scaled: bool = False):
        self.wants, self.named, self.scaled = wants, Named(kind, wants), scaled

    def read(self, node: Any, reader: Any):
        for key, _ in node.entries.values() if isinstance(node, Mapping) else ():
            NameOf("the name of a coordinate", "coordinates").read(key, reader)
        found = self.named.read(node, reader)
        factor = f"factor of line {node.where.line}, {node.where.column}" if self.scaled else None
        for name, value in (found or {}).items():
            for expression in value if isinstance(value, list) else [value]:
                reader.along[expression.scalar] = name, factor
        return found

    def schema(self):
        return self.named.schema()


KIND = ByCoordinate(Quantity(), "a mapping from coordinates to values")
ABOUT = ("Which equilibrium is meant: the one nearest to this place, stable or not, as in `{x: 1 m}`; coordinates that "
         "are left out count as drawn. Distances are those of the coordinates, lengths divided by the size of the "
         "figure. The report says how far it lies from there.")
