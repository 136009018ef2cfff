"""Quantities of a scene over one or two of its parameters, and its natural modes followed by their shapes."""

from collections.abc import Callable, Sequence
from functools import cached_property
from itertools import product
from math import isclose
from typing import TYPE_CHECKING, Any

from vibcli.base.errors import PhysicsError, SpecError
from vibcli.base.named_tuple import NamedTuple
from vibcli.language.given_values import GivenValue
from vibcli.quantities.expression import value_of
from vibcli.quantities.quantity import declared
from vibcli.results.variants import Variants
from vibcli.symbolic.syntax import QuantityRef

if TYPE_CHECKING:
    import numpy as np

    from vibcli.language.reader import Expression
    from vibcli.results.branches import FollowedModes, NaturalModesAt
    from vibcli.results.problem import Problem


class SweptAxis(NamedTuple):
    """Values of a parameter, ascending. unit: the text of that in which they are told, '' of none; shown: their numbers
    in it; given(number): the GivenValue of any number in it."""

    name: str
    unit: str
    values: tuple[GivenValue, ...]
    shown: tuple[float, ...]
    given: Callable[[float], GivenValue]

    @property
    def in_si(self) -> list[float]:
        return [float(value.exact) for value in self.values]

    @property
    def by_ratio(self) -> bool:
        """Do its values grow by one ratio?"""
        return self.shown[0] > 0 and len(self.shown) > 2 and isclose(
            self.shown[1] / self.shown[0], self.shown[-1] / self.shown[-2], rel_tol=1e-6)


class Gap(NamedTuple):
    """Why quantities have no value at some places of the grid, in order."""

    texts: tuple[str, ...]
    places: list[tuple[int, ...]]
    reason: str


class ModeCount(NamedTuple):
    """Places from the first to the last with one number of natural modes, 0 where they are not finite in number."""

    number: int
    first: int
    last: int


class Sweep:
    """Values of expressions of quantities, in these units, over the grid of some axes; `settle(problem)` gives values
    to what is chosen."""

    def __init__(self, problem: "Problem", axes: Sequence[SweptAxis], asked: "Sequence[Expression]",
                 units: Sequence[str], settle: "Callable[[Problem], Problem]") -> None:
        self.problem, self.axes, self.asked, self.units = problem, list(axes), list(asked), list(units)
        self._variants = Variants(problem, [{axis.name: axis.values} for axis in axes], settle)

    @property
    def invalid_end(self) -> "tuple[str, str] | None":
        """(values, message) of an end of the ranges at which there is no such scene; None where there is none."""
        for place in product(*((0, len(axis.values) - 1) for axis in self.axes)):
            found = self._variants.alone(place)
            if isinstance(found, SpecError):
                told = ", ".join(f"{axis.name} = {axis.values[i].expression.text}"
                                 for axis, i in zip(self.axes, place, strict=True))
                return told, found.diagnostics[0].message
        return None

    @property
    def shape(self) -> tuple[int, ...]:
        return tuple(len(axis.values) for axis in self.axes)

    @cached_property
    def columns(self) -> "list[np.ndarray]":
        """Of each expression an array over the grid, NaN where it has no value."""
        return self._found[0]

    @cached_property
    def gaps(self) -> list[Gap]:
        """Why there are none, one entry to each reason."""
        texts: dict[tuple[str, Any], list[str]] = {}
        for text, reason, place in self._found[1]:
            texts.setdefault((reason, place), []).append(text)
        found: dict[tuple[tuple[str, ...], str], list[Any]] = {}
        for (reason, place), names in texts.items():
            found.setdefault((tuple(names), reason), []).append(place)
        return [Gap(names, places, reason) for (names, reason), places in found.items()]

    @cached_property
    def done(self) -> int:
        """How many of the places were reached before an interrupt."""
        return self._found[2]

    @cached_property
    def branches(self) -> "FollowedModes | None":
        """The natural modes followed by their shapes, where they are asked for over one parameter; None elsewhere."""
        from vibcli.results.branches import followed

        if len(self.axes) > 1 or not any(map(self.numbered, self.asked)):
            return None
        spectra = self._found[3]
        if any(one is not None for one in spectra):
            return followed(spectra, self._between)
        return None

    def numbered(self, expression: "Expression") -> "int | None":
        """The number of the natural mode that a quantity is one of; None of others."""
        tree = expression.tree
        if not isinstance(tree, QuantityRef) or declared(tree).indices[:1] != ("mode",) or tree.args:
            return None
        return int(tree.indices[0]) if tree.head in OF_NATURAL_MODES else None

    def branch(self, expression: "Expression") -> "np.ndarray | None":
        """The branch to which the natural mode of a quantity belongs at each value, 0 where it has none, or was
        not reached; None of others."""
        import numpy as np

        number, found = self.numbered(expression), self.branches
        if number is None or found is None:
            return None
        belongs = np.zeros(self.shape[0], dtype=int)
        for k, label in enumerate(found.branches):
            belongs[k] = 0 if label is None or number > len(label) else label[number - 1]
        return belongs

    @cached_property
    def mode_counts(self) -> "list[ModeCount]":
        """Runs of places with one number of natural modes, where these are asked for over one parameter."""
        found: list[ModeCount] = []
        for k, count in enumerate(self._found[4]):
            if found and found[-1].number == count:
                found[-1] = found[-1]._replace(last=k)
            else:
                found.append(ModeCount(count, k, k))
        return found

    @cached_property
    def _found(self) -> "tuple[list[np.ndarray], list[Any], int, list[Any], list[Any]]":
        """(arrays, [(text, reason, place)], places reached, NaturalModesAt or None of each, numbers of modes)."""
        import numpy as np

        arrays, gaps, spectra, counts, done = [np.full(self.shape, np.nan) for _ in self.asked], [], [], [], 0
        follow = len(self.axes) == 1 and any(map(self.numbered, self.asked))
        total = arrays[0].size
        with self.problem.work.task("the sweep") as task:
            try:
                for place, problem in self._variants:
                    row = [_value(problem, expression) for expression in self.asked]
                    spectrum = _spectrum(problem, self.axes[0].shown[place[0]]) if follow else None
                    for array, expression, (value, reason) in zip(arrays, self.asked, row, strict=True):
                        array[place] = value
                        gaps += [(expression.text, reason, place)] if reason else []
                    spectra.append(spectrum)
                    counts += [_count(problem)] * follow
                    done += 1
                    task.step(done / total)
            except KeyboardInterrupt:
                self.problem.work.interrupt()
        return arrays, gaps, done, spectra, counts

    def _between(self, value: float) -> Any:
        axis = self.axes[0]
        return _spectrum(self._variants.at({axis.name: axis.given(value)}), value)


OF_NATURAL_MODES = ("omega", "frequency", "period", "growth_rate", "mode", "modal_mass")


def _value(problem: "Problem | SpecError | PhysicsError", expression: "Expression") -> tuple[float, str]:
    """(the value of an expression, '') or (NaN, why there is none)."""
    try:
        if isinstance(problem, Exception):
            raise problem
        return float(value_of(problem, expression)[0]), ""
    except SpecError as error:
        return float("nan"), error.diagnostics[0].message
    except PhysicsError as error:
        return float("nan"), error.message


def _count(problem: Any) -> int:
    """The number of natural modes; 0 where there are none, or no end of them."""
    if isinstance(problem, Exception):
        return 0
    try:
        modes = problem.modal.modes
    except (SpecError, PhysicsError):
        return 0
    return len(modes) if modes.finite else 0


def _spectrum(problem: Any, value: float) -> "NaturalModesAt | None":
    """The natural frequencies and shapes; None where they are not all real and finite in number."""
    import numpy as np

    from vibcli.results.branches import NaturalModesAt

    if isinstance(problem, Exception):
        return None
    try:
        modes = problem.modal.modes
    except (SpecError, PhysicsError):
        return None
    if not modes.finite or not modes or any(mode.omega is None or np.iscomplexobj(mode.shape) for mode in modes):
        return None
    shapes = np.array([np.asarray(mode.shape, dtype=float) for mode in modes]).T
    if shapes.shape[0] != shapes.shape[1]:
        return None
    return NaturalModesAt(value, np.array([float(mode.omega) for mode in modes]), shapes)
