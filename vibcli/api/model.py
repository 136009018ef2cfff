"""A scene and its answers, for Python: quantities by name, responses, reports, pictures."""

from functools import cached_property
from math import nan
from typing import TYPE_CHECKING, Any

from vibcli.api import given
from vibcli.api.source import SceneSource, problem_of, settled
from vibcli.base.errors import Diagnostic, PhysicsError, SpecError, Where
from vibcli.language.document.mapping import text_of

if TYPE_CHECKING:
    from concurrent.futures import Executor

    from numpy import ndarray
    from numpy.typing import ArrayLike

    from vibcli.analyses.closed_form.closed_forms import ClosedMode
    from vibcli.api.expressions import MotionEquation, SymbolicExpression
    from vibcli.api.pictures import SceneDrawing
    from vibcli.api.response import SampledResponse
    from vibcli.api.sweep import SweptValues
    from vibcli.api.values import QuantityValue
    from vibcli.api.variants import HomeworkVariants
    from vibcli.report.blocks import Document
    from vibcli.results.other_values import OtherValues
    from vibcli.results.problem import Problem
    from vibcli.symbolic.node import Node

__all__ = ["Model", "PhysicsError", "SpecError"]


class Model:
    """A scene, or a case of it. Its answers are found when they are asked for, and kept; PhysicsError where there is no
    such answer. Values are in SI units; those of a scene in letters are SymbolicExpressions."""

    def __init__(self, source: SceneSource, problem: "Problem", settings: dict[str, tuple[Any, ...]] | None = None,
                 case: str | None = None, accuracy: float | None = None, others: "OtherValues | None" = None) -> None:
        self._source, self._settings, self._case, self._accuracy = source, settings or {}, case, accuracy
        self._given_others, self._as_given = others, problem
        self._as_read = problem if accuracy is None else problem.with_accuracy(accuracy)

    @cached_property
    def _problem(self) -> "Problem":
        """The Problem, with values for what it chooses."""
        return settled(self._as_read)

    @property
    def coordinates(self) -> list[str]:
        """The names of the degrees of freedom."""
        return list(self._problem.scene.coordinates)

    @property
    def cases(self) -> list[str]:
        """The names of the cases of the file."""
        return list(self._as_read.spec.cases)

    def case(self, name: str) -> "Model":
        """A case of the file."""
        return Model(self._source, _case(self._as_read, name), self._settings, name, self._accuracy)

    def with_accuracy(self, accuracy: float | str) -> "Model":
        """The scene with its motions integrated so accurately: the error of each coordinate relative to how far it
        goes, 1e-9 unless asked."""
        try:
            asked = given.accuracy(str(accuracy))
        except ValueError as error:
            raise SpecError([Diagnostic(Where(f"with_accuracy {accuracy}", 1, 1, 0), str(error))]) from None
        return Model(self._source, self._as_given, self._settings, self._case, asked, self._others)

    def with_values(self, **values: float | str) -> "Model":
        """The scene with other values of parameters: numbers in the unit of the file, texts with their own."""
        found = dict(self._settings)
        for name, value in values.items():
            try:
                found |= given.setting(name, text_of(value) or "", self._named, "with_values")
            except ValueError as error:
                raise SpecError([Diagnostic(Where(f"with_values {name}", 1, 1, 0), str(error))]) from None
        problem = self._others.at(found)
        if problem is None:
            problem = problem_of(self._source, found)
            problem = problem if self._case is None else _case(problem, self._case)
        return Model(self._source, problem, found, self._case, self._accuracy, self._others)

    @cached_property
    def _named(self) -> set[str]:
        """The names to which values can be given."""
        return given.parameters_of(self._source.node)

    @cached_property
    def _others(self) -> "OtherValues":
        """What shares the derivation of the scene as it was read."""
        from vibcli.results.other_values import OtherValues

        return self._given_others or OtherValues(self._as_given)

    def sweep(self, *quantities: str, **parameters: "ArrayLike") -> "SweptValues":
        """Quantities over ascending values of parameters, in the unit of the file; over two, over their grid. The
        scene is derived once, and evaluated by arrays where they settle it."""
        from vibcli.api.sweep import swept

        return swept(self._as_read, quantities, parameters)

    def variants(self, executor: "Executor | None" = None) -> "HomeworkVariants":
        """All variants of the scene as homework, as its `variants:` says: solved, by the executor where one is given,
        and passed through the gates."""
        from vibcli.api.variants import variants_of

        return variants_of(self._as_read, self._source, self._case, self._settings, executor)

    @property
    def omega(self) -> "ndarray | list[SymbolicExpression]":
        """Natural angular frequencies [rad/s], an array of n ascending ones, the dampers left out; NaN of a mode that
        grows."""
        if self._problem.numeric.has_free_symbols:
            return [self._letters(mode.omega) for mode in self._closed_modes(stable=True)]
        import numpy as np

        from vibcli.report.sections.shown_modes import shown

        return np.array([nan if mode.omega is None else float(mode.omega) for mode in shown(self._problem)])

    @property
    def zeta(self) -> "ndarray | list[SymbolicExpression]":
        """Damping ratios, an array in the order of the damped modes, none where nothing damps; NaN of a mode that has
        none."""
        if self._problem.numeric.has_free_symbols:
            return [self._letters(mode.zeta) for mode in self._closed_modes() if mode.zeta is not None]
        import numpy as np

        from vibcli.report.sections.shown_modes import shown_damped

        found = {mode.index: mode.zeta for mode in reversed(shown_damped(self._problem) or ())}
        return np.array([nan if found[index] is None else float(found[index]) for index in sorted(found)])

    @property
    def modes(self) -> "ndarray | list[list[SymbolicExpression]]":
        """Mode shapes, the first coordinate that moves being 1: an array of n coordinates × m modes, complex where
        phases differ; in letters a list of modes, each a list of amplitudes."""
        if self._problem.numeric.has_free_symbols:
            from vibcli.base.errors import NotInLetters
            from vibcli.quantities.letters import GIVE_VALUES

            modes = self._closed_modes()
            if any(mode.shape is None for mode in modes):
                raise NotInLetters("the mode shapes are not all found in letters", GIVE_VALUES)
            return [[self._letters(part) for part in mode.shape] for mode in modes]
        import numpy as np

        from vibcli.report.sections.shown_modes import shown

        shapes = [[complex(part) for part in self._problem.modal.shape(mode)] for mode in shown(self._problem)]
        found = np.array(shapes, dtype=complex).reshape(len(shapes), len(self.coordinates)).T
        return found if found.imag.any() else found.real

    @property
    def equations(self) -> "dict[str, MotionEquation]":
        """{coordinate: its equation of motion}."""
        from vibcli.api.expressions import equations_of

        return equations_of(self._problem)

    @property
    def equilibrium(self) -> "dict[str, float] | dict[str, SymbolicExpression]":
        """{coordinate: its value in equilibrium}."""
        if self._problem.numeric.has_free_symbols:
            return {name: self._letters(node) for name, node in self._problem.symbolic.equilibrium_position.items()}
        return {name: float(self._problem.configuration.equilibrium.values[name]) for name in self.coordinates}

    def __getitem__(self, quantity: str) -> "QuantityValue":
        """Any quantity that `answers` of a scene may ask for, or an expression of some."""
        from vibcli.api.values import quantity_value

        return quantity_value(self._problem, quantity)

    def response(self, until: float | str | None = None, points: int = 1001) -> "SampledResponse":
        """The motion in time, up to an instant [s] or as the file says, at so many instants."""
        from vibcli.api.response import response

        return response(self._problem, until, points)

    def frf(self, signal: str, driver: str, *, omega: "ArrayLike | None" = None,
            f: "ArrayLike | None" = None) -> "ndarray":
        """Complex frequency response of a signal to a unit of an input, at angular frequencies `omega` [rad/s] or at
        frequencies `f` [Hz]: an array of their shape. NaN where an undamped scene is in resonance."""
        from vibcli.api.response import frequency_response

        return frequency_response(self._problem, signal, driver, omega, f)

    def draw(self, mode: int | None = None, both: bool = False) -> "SceneDrawing":
        """The scene as a figure, or the shape of a mode on it: shown by a notebook, or written by `.save(path)`."""
        from vibcli.api.pictures import SceneDrawing

        return SceneDrawing.of(self._as_read if mode is None else self._problem, mode, both)

    def diagrams(self, mode: int | None = None, at: float | None = None, amplitudes: bool = False) -> "SceneDrawing":
        """Forces and moments along members, below the scene: in equilibrium, of a mode, of the motion at the instant
        `at` [s], or amplitudes of the steady state."""
        from vibcli.api.pictures import SceneDrawing
        from vibcli.report.sections.force_diagrams import WhichForces

        return SceneDrawing.of_forces(self._problem, WhichForces(mode, at, amplitudes))

    def __repr__(self) -> str:
        from vibcli.report.document import title_of

        return f"<Model: {title_of(self._as_read.spec, self._case)}>"

    def _repr_html_(self) -> str:
        from vibcli.report.formats.html import fragment

        return fragment(self._document(pictures=True))

    def _repr_latex_(self) -> str:
        from vibcli.report.formats.latex import fragment

        return fragment(self._document())

    def _document(self, pictures: bool = False) -> "Document":
        """The solution, as `vibcli solve` writes it."""
        from vibcli.api.reports import report, solution
        from vibcli.report.blocks import Refusal

        made = report(self._problem, [*["schematic"] * pictures, *solution(self._problem)], pictures=pictures)
        document, refusal = made.document(self._case), made.refusal
        return document if refusal is None else document._replace(refusal=Refusal(refusal.message, refusal.hint))

    def _closed_modes(self, stable: bool = False) -> "list[ClosedMode]":
        from vibcli.quantities.letters import closed_modes

        found = closed_modes(self._problem)
        growing = next((mode.index for mode in found if mode.unstable), None) if stable else None
        if growing is not None:
            raise PhysicsError(f"mode {growing} is unstable: it has a growth rate, no frequency",
                               f"ask for growth_rate[{growing}]")
        return found

    def _letters(self, node: "Node") -> "SymbolicExpression":
        from vibcli.api.expressions import SymbolicExpression

        return SymbolicExpression(node)


def _case(problem: "Problem", name: str) -> "Problem":
    try:
        return given.case(problem, name)
    except ValueError as error:
        raise SpecError([Diagnostic(Where(problem.spec.file, 1, 1, 0), str(error))]) from None
