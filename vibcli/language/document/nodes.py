"""The nodes of a scene file: texts, lists and mappings, each with its place."""


class Scalar:
    """A piece of text. `quoted` is true for '…', "…", | and >; a value left empty is '' and not quoted."""

    __slots__ = ("inset", "quoted", "text", "where")

    def __init__(self, text, where, quoted=False, inset=None):
        self.text, self.where, self.quoted, self.inset = text, where, quoted, inset

    def place(self, offset, width=1):
        """The place of text[offset : offset + width]; the scalar's start where text was folded or escaped."""
        if self.inset is None:
            return self.where
        offset = min(max(offset, 0), len(self.text))
        return self.where.shifted(self.inset + offset, max(1, min(width, len(self.text) - offset)))


class Sequence:
    """A list of nodes."""

    __slots__ = ("items", "where")

    def __init__(self, where):
        self.items, self.where = [], where

    def widen(self, width):
        """It ends so many characters further on its line."""
        self.where = self.where._replace(width=width)


class Mapping:
    """Entries in file order: {key text: (key Scalar, value node)}."""

    __slots__ = ("entries", "where")

    def __init__(self, where, entries=None):
        self.entries, self.where = {} if entries is None else entries, where

    def widen(self, width):
        """It ends so many characters further on its line."""
        self.where = self.where._replace(width=width)
