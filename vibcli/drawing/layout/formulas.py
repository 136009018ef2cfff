"""Expressions as runs of letters: quantities slanted, products without dots."""

import re
from typing import TYPE_CHECKING, Any

from vibcli.drawing.layout import lettering
from vibcli.notation.plain import Plain

if TYPE_CHECKING:
    from vibcli.drawing.canvas.primitives import Run
    from vibcli.symbolic.node import Node

_NUMBER_BEFORE = re.compile("(?<![^(−])([\\d.]+)·")        # 4k, but F₀ sin(Ωt)


class _Marked(Plain):
    """Plain notation in which names are marked off with their indices."""

    def symbol(self, name: str) -> str:
        return lettering.marked(name)

    def product(self, value: Any, args: Any) -> str:
        return _NUMBER_BEFORE.sub(r"\1", super().product(value, args)).replace("·", " ")


def written(node: "Node", size: float = lettering.SIZE) -> "tuple[Run, ...]":
    """The runs of an expression."""
    return lettering.runs(_Marked()(node).replace("\u00a0", " "), size)
