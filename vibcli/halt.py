"""The place where YAML's parser gave up, why, and what stands there."""

import re

from vibcli import decoding

_WORD = re.compile(r"[^\s,\[\]{}:'\"]+|.", re.DOTALL)


class Halt:
    """Where the parser gave up, why, and what stands there. Lines and columns count from 1."""

    def __init__(self, error, tree):
        mark = getattr(error, "problem_mark", None)
        start = getattr(error, "context_mark", None)
        self.problem = f"{getattr(error, 'context', None)} {getattr(error, 'problem', None) or error}"
        self.tree, self.source, self.file = tree, tree.source, tree.file
        self.index = min(mark.index, len(self.source)) if mark else 0
        self.start = start.index if start else None
        self.where = decoding.place(self.source, self.index, self.file)
        self.char = self.source[self.index : self.index + 1]
        self.word = _WORD.match(self.source, self.index)[0] if self.char else ""
        self.at_end = not self.source[self.index :].strip()

    def at(self, index, width=1):
        return decoding.place(self.source, index, self.file, width)

    def here(self):
        return self.where._replace(width=max(1, len(self.word)))

    def before(self):
        """The text of the line up to where the parser gave up."""
        return self.source[self.index - self.where.column + 1 : self.index]

    def line(self, where=None):
        """The text of a line without its break."""
        where = where or self.where
        return decoding.split(self.source)[where.line - 1]
