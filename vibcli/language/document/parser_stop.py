"""The place where YAML's parser gave up, why, and what stands there."""

import re

from vibcli.base import decoding
from vibcli.base.diagnostics import quoted

CLOSER = {"[": "]", "{": "}"}
LOOK_ABOVE = "compare the indentation, quotes and brackets with the lines above"
QUOTE_IT = "put the whole value in quotes"

_WORD = re.compile(r"[^\s,\[\]{}:'\"]+|.", re.DOTALL)


class Halt:
    """Where the parser stopped: `index`, `where`, and the `char` and `word` there; `start`, the index of what
    it could not finish, such as an opening quote."""

    def __init__(self, error, tree):
        mark, start = getattr(error, "problem_mark", None), getattr(error, "context_mark", None)
        self.problem = f"{getattr(error, 'context', None)} {getattr(error, 'problem', None) or error}"
        self.tree, self.file = tree, tree.file
        self.source = tree.source.translate(tree.hidden) if tree.hidden else tree.source
        self.index = min(mark.index, len(self.source)) if mark else 0
        self.start = start.index if start else self.index
        self.where = self.at(self.index)
        self.char = self.source[self.index : self.index + 1]
        self.word = _WORD.match(self.source, self.index)[0] if self.char else ""
        self.at_end = not self.source[self.index :].strip()

    def at(self, index, width=1):
        return decoding.place(self.source, index, self.file, width)

    def here(self):
        """The place of the word at which the parser stopped."""
        return self.where._replace(width=max(1, len(self.word)))

    def found(self):
        return "the file ends" if self.at_end else f"found {quoted(self.word)}"

    def before(self):
        """The text of the line up to where the parser stopped."""
        return self.source[self.index - self.where.column + 1 : self.index]

    def line(self, where=None):
        """The text of the line of a place."""
        return decoding.split(self.source)[(where or self.where).line - 1]

    def bracket(self):
        """The index of the innermost open bracket."""
        return next((i for _, _, i in reversed(self.tree.stack) if self.source[i] in CLOSER), self.index)
