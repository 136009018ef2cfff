"""What is wrong with a scene."""

from vibcli.base.errors import Diagnostic, SpecError


class Reports:
    """Diagnostics: kept while a scene is built; of one that is finished raised, since nobody looks at what is kept any
    more."""

    __slots__ = ("diagnostics", "finished")

    def __init__(self):
        self.diagnostics, self.finished = [], False

    def report(self, where, message, hint=None):
        """Something is wrong at a place of the file."""
        self.diagnostics.append(Diagnostic(where, message, hint))
        if self.finished:
            raise SpecError(self.diagnostics[-1:])

    def finish(self):
        """The scene is built: SpecError where it is wrong."""
        if self.diagnostics:
            raise SpecError(self.diagnostics)
        self.finished = True
