"""Motions in time as data: what is asked, sampled series with their units, extremes, steady amplitudes."""

import re
from collections.abc import Callable, Iterator, Mapping, Sequence
from typing import TYPE_CHECKING, Any, cast

from vibcli.base.errors import NoBound, NotFixed, PhysicsError, SpecError
from vibcli.base.named_tuple import NamedTuple
from vibcli.language.reader import Reader
from vibcli.language.signal_names import signal_name
from vibcli.quantities.dimensions import checker, text_of
from vibcli.quantities.signal_dimensions import input_dimension, inputs, output_dimension
from vibcli.reader.sections.find import FREQUENCY_RESPONSE, RESPONSE
from vibcli.report.sections.parameters import unit
from vibcli.symbolic.syntax import NameRef, Sum

if TYPE_CHECKING:
    from fractions import Fraction

    from vibcli.base.errors import Where
    from vibcli.language.reader import Expression
    from vibcli.language.spec import Spec
    from vibcli.report.wanted import Wanted
    from vibcli.results.problem import Problem
    from vibcli.results.response import Response
    from vibcli.results.signal import Signal


OF_THE_SCENE = re.compile(r"(?<![\w.])[^\W\d]\w*(?![\w.(\[])")     # names but those of elements and functions


class RequestedSignal(NamedTuple):
    """A signal that is asked for: its text, its tree, its dimension, and the Signal."""

    text: str
    tree: tuple[Any, ...]
    dimension: "Mapping[str, Fraction | int]"
    signal: Any

    @property
    def label(self) -> str:
        """The signal as it is printed: a coordinate by its symbol."""
        return symbol(self.text)

    @property
    def unit(self) -> str:
        return "rad" if self.dimension == {} else text_of(self.dimension, self.tree)


def symbol(text: str) -> str:
    """A signal as it is printed: a coordinate or its rate by its symbol, L·φ̇, s.force."""
    if text.rstrip("'").isidentifier():
        from vibcli.notation.plain import plain

        return plain.symbol(text)
    from vibcli.notation.as_printed import as_printed

    return as_printed(text, OF_THE_SCENE.findall(text))


def require_known(spec: "Spec", signals: "Sequence[Expression]", inputs: "Sequence[Expression]" = ()) -> None:
    """SpecError where signals or inputs (Expressions) are not of this scene."""
    from vibcli.reader.quantity_check import check_questions

    reader = Reader()
    check_questions(spec, reader, signals, inputs)
    if reader.diagnostics:
        raise SpecError(reader.diagnostics)


def trees_asked(problem: "Problem", word: str, given: "Sequence[Expression]" = ()) -> list[tuple[str, NameRef | Sum]]:
    """[(text, tree)] of the signals asked: those given, else those of `find`, else the usual ones."""
    return [(text, tree) for text, tree, _ in _signals_asked(problem, word, given)]


def _signals_asked(problem: "Problem", word: str,
                   given: "Sequence[Expression]") -> "list[tuple[str, NameRef | Sum, Where | None]]":
    """(text, tree, place in the file or None)"""
    if given:
        reader = Reader(members=problem.spec.members)
        given = [signal.with_tree(reader.at_places(signal.tree)) for signal in given]
        require_known(problem.spec, given)
        return [(signal.text, signal.tree, signal.where) for signal in given]
    find = problem.spec.get("find")
    record = find.about(word) if find is not None else None
    if record is not None and "of" in record:
        return [(signal.text, signal.tree, signal.where) for signal in record["of"]]
    return [(name, NameRef(0, len(name), name, 0), None) for name in _usual(problem)]


def _usual(problem: "Problem") -> Any:
    """The names of the coordinates, of members those of their stations that are displacements or turns; where there is
    none, the middles of members."""
    spec = problem.spec
    if not spec.members:
        return spec.coordinates
    stations = [name for name in problem.scene.coordinates if signal_name(name).part in ("u", "phi")]
    return [*spec.coordinates, *stations] or [_middle(problem, name) for name in spec.members]


def _middle(problem: "Problem", name: str) -> str:
    from vibcli.notation.scene_language import language

    member = problem.scene.members[name]
    length = language(member.length)
    return f"{name}.{member.kind.motion}({length if length.isidentifier() else f'({length})'}/2)"


def signals_asked(problem: "Problem", given: "Sequence[Expression]" = ()) -> list[RequestedSignal]:
    """The Asked signals of a motion in time."""
    return [RequestedSignal(text, tree, dimension_of(problem, tree), _kept(problem.response, tree, where))
            for text, tree, where in _signals_asked(problem, RESPONSE, given)]


def _kept(response: "Response", tree: NameRef | Sum, where: "Where | None") -> "Signal":
    try:
        return response.kept_signal(tree)
    except PhysicsError as error:
        raise error.told(where) from None


def dimension_of(problem: "Problem", tree: "NameRef | Sum") -> "Mapping[str, Fraction | int]":
    """The dimension of a signal, {} of a pure number."""
    return problem.spec.dimensions.resolve(checker(problem.spec).dimension(tree) or {})


def extremes(asked: Any, until: Any) -> Any:
    """[(signal, BoundedExtreme of the largest, of the smallest)], for what is not known a word that says why."""
    return [(one, *(if_known(lambda one=one, sense=sense: one.signal.bounded_extreme(0.0, until, sense), str)
                    for sense in (1, -1))) for one in asked]


def if_known(found: Callable[..., Any], otherwise: Callable[[str], Any]) -> Any:
    """What a function finds; else, of a word that says why statics alone does not fix it or no bound is known."""
    try:
        return found()
    except (NotFixed, NoBound) as error:
        return otherwise(error.CELL)


def names_asked(problem: "Problem", word: str, given: "Sequence[Expression]" = ()) -> Iterator[str]:
    """The names of the signals asked for, of which none may be a sum or product."""
    for text, tree in trees_asked(problem, word, given):
        if not isinstance(tree, NameRef):
            raise PhysicsError(f"'{text}' is a sum or product: formulas are those of one signal", "ask for its parts")
        yield text


def curves_asked(problem: "Problem", wanted: "Wanted") -> Iterator[tuple[str, str, str]]:
    """[(signal, input, unit of the response)] of the frequency responses that are asked for."""
    driver = _input_asked(problem, wanted.driver)
    for text in names_asked(problem, FREQUENCY_RESPONSE, wanted.signals):
        dimensions = output_dimension(problem.spec, text), input_dimension(problem.spec, driver)
        yield text, driver, _ratio(*map(unit, map(problem.spec.dimensions.resolve, dimensions)))


def _ratio(above: str, below: str) -> str:
    """The unit of a quotient, as the field writes it: m/N, (m/s)/N."""
    if above == below:
        return "1"
    above, below = (f"({text})" if set("/·") & set(text) else text for text in (above, below))
    return f"{above}/{below}"


def _input_asked(problem: "Problem", given: Any) -> str:
    """The name of the input: that given, that of `find`, else the first load, driven point or coordinate."""
    if given is not None:
        require_known(problem.spec, (), [given])
        return cast("str", given.text)
    find = problem.spec.get("find")
    record = find.about(FREQUENCY_RESPONSE) if find is not None else None
    if record is not None and "to" in record:
        return cast("str", record["to"].text)
    known = inputs(problem.spec)
    if not known and not problem.spec.members:
        from vibcli.mechanics.system import nothing_moves

        raise nothing_moves()
    if not known:
        raise PhysicsError("nothing drives this scene", "add a force on a point of a member, as in `points: {tip: "
                           f"{{body: {next(iter(problem.spec.members))}, at: …}}}}`, `forces: {{drive: {{at: tip, "
                           "force: 1 N}}`")
    return known[0]
