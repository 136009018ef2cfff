"""Motions in time as data: what is asked, sampled series with their units, extremes, steady amplitudes."""

from typing import NamedTuple

from vibcli import units
from vibcli.asking_signals import check_questions, signal_tree_dimension
from vibcli.elements.find import FREQUENCY_RESPONSE, RESPONSE
from vibcli.errors import SpecError
from vibcli.reading import Reader

POINTS = 1001


class Asked(NamedTuple):
    """A signal that is asked for: its text, its tree, its dimension, and the Signal."""

    text: str
    tree: tuple
    dimension: dict
    signal: object

    @property
    def unit(self):
        return "rad" if self.dimension == {} else units.text(self.dimension)


def require_known(spec, signals, inputs=()):
    """SpecError where signals or inputs (Expressions) are not of this scene."""
    reader = Reader()
    check_questions(spec, reader, signals, inputs)
    if reader.diagnostics:
        raise SpecError(reader.diagnostics)


def trees_asked(problem, word, given=()):
    """[(text, tree)] of the signals asked: those given, else those of `find`, else the coordinates."""
    if given:
        require_known(problem.spec, given)
        return [(signal.text, signal.tree) for signal in given]
    find = problem.spec.get("find")
    record = find.about(word) if find is not None else None
    if record is not None and "of" in record:
        return [(signal.text, signal.tree) for signal in record["of"]]
    return [(name, ("name", 0, len(name), name, 0)) for name in problem.spec.coordinates]


def signals_asked(problem, given=()):
    """The Asked signals of a motion in time."""
    return [Asked(text, tree, _dimension(problem, tree), problem.motion.signal(tree))
            for text, tree in trees_asked(problem, RESPONSE, given)]


def _dimension(problem, tree):
    return problem.spec.dimensions.resolve(signal_tree_dimension(problem.spec, tree) or {})


def extremes(asked, until):
    """[(signal, (t, value) of the largest, of the smallest)]."""
    return [(one, one.signal.extreme(0.0, until, 1), one.signal.extreme(0.0, until, -1)) for one in asked]


def input_asked(problem, given=None):
    """The name of the input of a frequency response: that given, that of `find`, else the only one or the first."""
    if given is not None:
        require_known(problem.spec, (), [given])
        return given.text
    find = problem.spec.get("find")
    record = find.about(FREQUENCY_RESPONSE) if find is not None else None
    if record is not None and "to" in record:
        return record["to"].text
    from vibcli.asking_signals import inputs

    return inputs(problem.spec)[0]
