"""Places at which things are drawn: [x, y], or the name of a point that is drawn there."""

from typing import TYPE_CHECKING, Any

from vibcli.language.document.document import Scalar
from vibcli.language.kinds import NameOf, OneOf, in_square_brackets, vector
from vibcli.symbolic.parser import plain_name

if TYPE_CHECKING:
    from vibcli.language.reader import Expression, Reference


class NamedPlace(list["Expression"]):
    """The place [x, y] at which a named point is drawn: filled in once all points are known."""

    __slots__ = ("name",)

    def __init__(self, name: "Reference") -> None:
        super().__init__()
        self.name = name


class _PointAsDrawn(NameOf):
    """The name of a point where the place at which it is drawn is meant."""

    def __init__(self) -> None:
        super().__init__("a place [x, y] or the name of a point", "points")

    def read(self, node: Any, reader: Any) -> Any:
        text = node.text.strip() if isinstance(node, Scalar) else ""
        if not plain_name(text).isidentifier():
            return reader.expected(node, self.wants, in_square_brackets(text))
        name = super().read(node, reader)
        reader.named_places.append(NamedPlace(name))
        return reader.named_places[-1]


DRAWN = OneOf("a place [x, y] or the name of a point", scalar=_PointAsDrawn(), sequence=vector("m", "a place [x, y]"))
