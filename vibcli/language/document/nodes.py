"""The nodes of a scene file: texts, lists and mappings, each with its place."""

from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    from vibcli.base.errors import Where


class Scalar:
    """A piece of text. `quoted` is true for '…', "…", | and >; a value left empty is '' and not quoted."""

    __slots__ = ("inset", "quoted", "text", "where")

    def __init__(self, text: str, where: "Where | None", quoted: bool = False, inset: int | None = None) -> None:
        self.text, self.where, self.quoted, self.inset = text, where, quoted, inset

    def place(self, offset: int, width: int = 1) -> "Where":
        """The place of text[offset : offset + width]; the scalar's start where text was folded or escaped."""
        if self.inset is None:
            return self.where
        offset = min(max(offset, 0), len(self.text))
        return self.where.shifted(self.inset + offset, max(1, min(width, len(self.text) - offset)))


class Sequence:
    """A list of nodes."""

    __slots__ = ("items", "where")

    def __init__(self, where: "Where") -> None:
        self.items, self.where = [], where

    def widen(self, width: int) -> None:
        """It ends so many characters further on its line."""
        self.where = self.where._replace(width=width)


class Mapping:
    """Entries in file order: {key text: (key Scalar, value node)}."""

    __slots__ = ("entries", "where")

    def __init__(self, where: "Where", entries: "dict[str, tuple[Scalar, Any]] | None" = None) -> None:
        self.entries, self.where = {} if entries is None else entries, where

    def widen(self, width: int) -> None:
        """It ends so many characters further on its line."""
        self.where = self.where._replace(width=width)


if TYPE_CHECKING:
    DocumentNode = Scalar | Sequence | Mapping
