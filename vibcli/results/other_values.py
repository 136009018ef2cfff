"""A scene with other values of its parameters: by the expressions of the scene as it was read, where the new values
would be drawn alike.

While a scene is drawn and linearised, numbers are read off it: lengths, which side, what coincides. The scene is drawn
once more with numbers that remember what was decided by them; where all of that comes out the same at other values,
they have the same expressions. What is no such value is not found here, and is to be read anew.
"""

from collections.abc import Callable, Iterable, Iterator, Mapping
from contextlib import suppress
from functools import cached_property, partial
from typing import TYPE_CHECKING, Any

from vibcli.analyses.modal.modal_analysis import ModalAnalysis
from vibcli.base.errors import PhysicsError, SpecError
from vibcli.base.named_tuple import NamedTuple
from vibcli.language.other_literals import GivenByLiteral, OtherLiterals, hanging_on
from vibcli.mechanics.configuration import Configuration
from vibcli.mechanics.numeric_system import NumericSystem
from vibcli.mechanics.system import MechanicalSystem
from vibcli.results.problem import Problem
from vibcli.results.variants import structure
from vibcli.symbolic.evaluation import Floats, evaluate
from vibcli.symbolic.expression_graph import reachable
from vibcli.symbolic.watched_numbers import Decisions

if TYPE_CHECKING:
    from vibcli.language.document.nodes import Scalar
    from vibcli.language.spec import Spec
    from vibcli.mechanics.linearisation import Linearisation
    from vibcli.scene.scene import Scene
    from vibcli.symbolic.node import Node
    from vibcli.symbolic.syntax import Number

PARTS = ("scene", "preloads", "linearisation", "time_dependent_linearisation", "linearisation_at_reference",
         "is_linear", "drawn_residual", "conservative")


class _Values(NamedTuple):
    """Other values: their Spec and Parameters, {parameter: float}, and which of them changed."""

    spec: "Spec"
    parameters: OtherLiterals
    sample: dict[str, float]
    changed: tuple[str, ...]

    def over(self, scene: "Scene") -> "Scene":
        """A Scene with these values."""
        return scene.with_other_values(self.spec, self.parameters, self.sample)


class OtherValues:
    """The Problems of a scene at other values, that share its derivation; `in_letters`: where letters stay, too, for
    who then looks whether all is written alike."""

    def __init__(self, problem: Problem, in_letters: bool = False) -> None:
        self.problem, self._decisions, self._in_letters = problem, Decisions(), in_letters
        self._systems = problem.system, MechanicalSystem(problem.spec, watched=self._decisions.watched)
        self._opened: dict[str, Any] = {}
        self._literals: dict[tuple[Any, ...], GivenByLiteral] = {}
        self._dependents: dict[tuple[str, ...], tuple[str, ...]] = {}
        self._kept: dict[tuple[str, ...], dict[str, float] | None] = {}

    def at(self, settings: Mapping[str, tuple[Any, Any]]) -> Problem | None:
        """The Problem of {parameter: (syntax tree, text)}; None where it is to be read anew."""
        values = None if self._known is None else self._values(settings)
        if self._known is None or values is None or not self._drawn_alike(values):
            return None
        like, known = self.problem.system, {**self._known, "scene": values.over(self.problem.scene)}
        system = MechanicalSystem(values.spec, known=known, shared=partial(self._shared, values), like=like)
        numeric = NumericSystem(system) if values.parameters.free else NumericSystem(
            system, None, values.sample, self._drawn(values.changed))
        return Problem(values.spec, work=system.work, modal=ModalAnalysis(Configuration(numeric)))

    @property
    def shares(self) -> bool:
        """Is the scene nothing but expressions, which other values may share?"""
        return self._known is not None

    def written_alike(self, problem: Problem) -> bool:
        """Is each R − r that was written until now, in the scene or what followed, written so at the values of one of
        the Problems, too?"""
        values, signs = problem.scene.sample, self.problem.scene.table.signs
        return all(signs[total] == (value < 0) for total, value in _known_of(signs, values))

    def _values(self, settings: "Mapping[str, tuple[Number, Scalar]]") -> _Values | None:
        """The _Values of settings; None where they would be read otherwise."""
        scene, literals = self.problem.scene, {}
        spec = self._with(self.problem.spec, settings, literals)
        if spec is None:
            return None
        hanging = self._hanging(tuple(literals))
        parameters = OtherLiterals(scene.parameters, spec.parameters, literals, hanging)
        sample = parameters.floats(scene.sample)
        return None if sample is None else _Values(spec, parameters, sample, hanging)

    def _with(self, spec: "Spec", settings: "Mapping[str, tuple[Number, Scalar]]",
              literals: dict[Any, Any]) -> "Spec | None":
        """The Spec with other values, in its cases too; None where it would be read otherwise. literals: to which their
        exact values are added."""
        parameters = dict(spec.parameters)
        for name in settings.keys() & parameters.keys():
            key = parameters[name], spec.free_numbers
            if key not in self._literals:
                self._literals[key] = GivenByLiteral(*key)
            found = self._literals[key].other(*settings[name])
            if found is None:
                return None
            parameters[name], literals[name] = found
        if not spec.cases:
            return spec.with_parameters(parameters)
        cases = {name: self._with(case, settings, {}) for name, case in spec.cases.items()}
        return None if None in cases.values() else spec.with_parameters(parameters)._replace(cases=cases)

    def _hanging(self, names: tuple[str, ...]) -> tuple[str, ...]:
        """The parameters that hang on some."""
        if names not in self._dependents:
            self._dependents[names] = hanging_on(self.problem.scene.parameters, names)
        return self._dependents[names]

    def _drawn(self, changed: tuple[str, ...]) -> dict[str, float]:
        """{coordinate: float} as drawn; None where it hangs on what is changed."""
        if changed not in self._kept:
            hangs = any(part.name in changed for part in reachable(self.problem.scene.drawn.values()))
            self._kept[changed] = None if hangs else self.problem.numeric.drawn_floats
        return self._kept[changed]

    def _drawn_alike(self, values: _Values) -> bool:
        return self._decisions.hold(self.problem.scene.sample, values.sample, values.changed)

    @cached_property
    def _known(self) -> dict[str, Any] | None:
        """{part: what it is} of what is shared; None where nothing can be."""
        if not _shareable(self.problem.spec):
            return None
        return self._both(_parts, lambda known: [(known["scene"], known["linearisation"])])

    def _shared(self, values: _Values, part: str) -> "tuple[Scene, Linearisation, Linearisation] | None":
        """(scene, Linearisation, that without excitation) of a scene with what drives it as coordinates; None where it
        is to be drawn anew."""
        if part not in self._opened:
            self._opened[part] = self._both(lambda system: getattr(system, part),
                                            lambda found: [(found[0], found[1]), (found[0], found[2])])
        found = self._opened[part]
        if found is None or not self._drawn_alike(values):
            return None
        return values.over(found[0]), *found[1:]

    def _both(self,
              parts: Callable[[MechanicalSystem], dict[str, Any]],
              forms: "Callable[..., list[tuple[Scene, Linearisation]]]") -> dict[str, Any] | None:
        """What is found of the scene as it was read, the same being watched; None where it is not to be shared."""
        try:
            found, watched = map(parts, self._systems)
            scenes = zip(forms(found), forms(watched), strict=True)
            alike = all(self._closed_form(one[0]) and structure(*one) == structure(*other) for one, other in scenes)
        except (SpecError, PhysicsError, ArithmeticError, TypeError, ValueError):
            return None
        return found if alike else None

    def _closed_form(self, scene: "Scene") -> bool:
        """Is a scene nothing but expressions of its parameters?"""
        table = scene.table
        return not (table.functions or table.records or table.definitions or
                    (scene.parameters.free and not self._in_letters))


def _shareable(spec: "Spec") -> bool:
    return not any(one.choices for one in (spec, *spec.cases.values()))


def _parts(system: MechanicalSystem) -> dict[str, Any]:
    """{part: what it is} of a system as it was read; None where a search finds the tensions under which it rests."""
    if system.settled is not None and not system.settled.told_by_statics:
        raise PhysicsError("a search finds the tensions of members")
    return {"settled": None} | {part: getattr(system, part) for part in PARTS}


def _known_of(nodes: "Iterable[Node]", values: Mapping[str, float]) -> "Iterator[tuple[Node, float]]":
    """(node, value) of those that are expressions of the parameters alone."""
    for node in nodes:
        with suppress(KeyError):
            yield node, *evaluate([node], Floats, values)
