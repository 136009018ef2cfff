"""Problem: the lazy pipeline from a Spec to its answers, by parts, each of which computes on first touch.

    system → numeric → configuration → modal            in letters: symbolic            in time: initial → response

Each part is an object of its own and knows those to its left only; a Problem holds them all.
"""

from collections.abc import Mapping
from functools import cached_property
from typing import TYPE_CHECKING, Any

from vibcli.base.errors import NotInLetters
from vibcli.base.stage import Stage
from vibcli.mechanics.system import MechanicalSystem

if TYPE_CHECKING:
    from fractions import Fraction

    from vibcli.analyses.closed_form.closed_forms import ClosedForms
    from vibcli.analyses.closed_form.frequency_response import Formula
    from vibcli.analyses.closed_form.steady_state import Steady
    from vibcli.analyses.modal.modal_analysis import ModalAnalysis
    from vibcli.base.work import Work
    from vibcli.language.spec import Spec
    from vibcli.mechanics.configuration import Configuration
    from vibcli.mechanics.equilibrium.all_equilibria import Equilibria
    from vibcli.mechanics.equilibrium.equilibrium import Equilibrium
    from vibcli.mechanics.initial_state import InitialState
    from vibcli.mechanics.numeric_system import NumericSystem
    from vibcli.mechanics.symbolic_linear import Tree
    from vibcli.mechanics.symbolic_system import SymbolicSystem
    from vibcli.results.free_motions import FreeMotions
    from vibcli.results.frequency_response import FrequencyResponse
    from vibcli.results.limit_loads import LimitLoads
    from vibcli.results.phase_plane import PhasePlane
    from vibcli.results.shared_solutions import KnownModes
    from vibcli.results.signals import LinearSignal
    from vibcli.results.steady_response import SteadyResponse
    from vibcli.scene.scene import Scene
    from vibcli.symbolic.node import Node
    from vibcli.symbolic.syntax import QuantityRef

STEADY = ("amplitude", "phase", "harmonic", "mean", "rms", "period")     # of what loads keep up, where they do


class Problem:
    """A scene to be answered: its parts. `given`: exact values for parameters that the file leaves as symbols; `work`:
    what counts its long work; `modal`: the parts of another Problem that this one shares; `choice`: what was chosen
    (inverse), where this is the scene with its solution, `earlier` being what it cost before; `end`: of a motion in
    time [s], where it is not that of the file; `signed`: have amplitudes a sign, so that a search sees where they
    vanish? `rough`: is it looked at by a search, for numbers in floats without their bounds? many: are its numbers
    arrays (quantities/at_once.py)?"""

    many = False

    def __init__(self, spec: "Spec", given: "Mapping[str, Fraction] | None" = None, work: "Work | None" = None,
                 modal: "ModalAnalysis | None" = None, choice: Any = None, earlier: Mapping[str, float] | None = None,
                 end: Any = None, signed: bool = False, rough: bool = False, digits: int | None = None,
                 symbolic: "SymbolicSystem | None" = None) -> None:
        self.spec, self.system = spec, MechanicalSystem(spec, given, work) if modal is None else modal.system
        self.work, self.costs = self.system.work, self.system.costs
        self.given: Mapping[str, Fraction] = self.system.given
        if modal is not None:
            self.modal, self.configuration, self.numeric = modal, modal.configuration, modal.numeric
            self.costs, self.given = modal.costs, modal.numeric.given
        if symbolic is not None:
            self.symbolic = symbolic
        self.choice, self.earlier, self.end, self.signed = choice, earlier or {}, end, signed
        self.rough, self.digits = rough, digits
        self._cases: dict[str, Problem] = {}
        self._curves: dict[tuple[str, str], FrequencyResponse] = {}
        self._limits: dict[str, LimitLoads] = {}
        self.measured: dict[str, tuple[float, float]] = {}     # {quantity as it is written: (value, error)}
        self.lettered: dict[str, tuple[Any, Any]] = {}         # {the same: (its Expression, its node or why none)}

    @cached_property
    def scene(self) -> "Scene":
        return self.system.scene

    @cached_property
    def numeric(self) -> "NumericSystem":
        from vibcli.mechanics.numeric_system import NumericSystem

        return NumericSystem(self.system)

    @cached_property
    def configuration(self) -> "Configuration":
        from vibcli.mechanics.configuration import Configuration

        return Configuration(self.numeric)

    @cached_property
    def modal(self) -> "ModalAnalysis":
        return _modes_of(self.configuration)

    @cached_property
    def symbolic(self) -> "SymbolicSystem":
        from vibcli.mechanics.symbolic_system import SymbolicSystem

        return SymbolicSystem(self.configuration, _modes_of)

    @property
    def timings(self) -> dict[str, float]:
        """{stage: seconds}."""
        return {**self.earlier, **self.costs}

    def without(self, damper: str) -> "Problem":
        """The problem with one damper taken out."""
        dampers = {name: record for name, record in self.spec.get("dampers").items() if name != damper}
        return self.with_spec(self.spec.with_sections(dampers=dampers))

    def with_spec(self, spec: "Spec") -> "Problem":
        """The scene of another Spec, with the same values and the same count of work."""
        return Problem(spec, self.given, self.work)

    def with_values(self, given: "Mapping[str, Fraction]") -> "Problem":
        """The same scene with values for its symbols, drawn anew."""
        return Problem(self.spec, {**self.given, **given}, self.work)

    def sharing(self, given: "Mapping[str, Fraction]", known: "KnownModes" = (None, None),
                equilibrium: "Equilibrium | None" = None) -> "Problem":
        """The same with the expressions of this scene: for values on which no sign in its geometry hangs; `known`: its
        natural modes and its damped ones, each None where they are to be found, as `equilibrium` is."""
        from vibcli.mechanics.configuration import Configuration

        configuration = Configuration(self.numeric.sharing(given), equilibrium)
        return self._copy(modal=_modes_of(configuration, known=known), end=None)

    def until(self, end: Any) -> "Problem":
        """The same scene with its motion looked at until an instant [s]."""
        return self if end == self.end else self._copy(end=end)

    def with_choice(self, choice: Any, problem: "Problem") -> "Problem":
        """The same scene as one with the solution of what a Problem chose."""
        return self._copy(choice=choice, earlier=problem.timings, end=problem.end)

    def with_signs(self) -> "Problem":
        """The same scene with amplitudes that have a sign."""
        return self._copy(signed=True)

    def roughly(self) -> "Problem":
        """The same scene for a look at it: numbers in floats, without their bounds."""
        return self._copy(rough=True)

    def with_accuracy(self, accuracy: float) -> "Problem":
        """The same scene with its motions integrated so accurately."""
        return self._copy(spec=self.spec.with_accuracy(accuracy))

    def with_digits(self, digits: int) -> "Problem":
        """The same scene with its quantities found to so many digits."""
        return self._copy(digits=digits)

    def afresh(self) -> "Problem":
        """The same with its expressions and element data, and nothing found of modes and motions: what its methods
        begin with."""
        return self._copy(modal=_modes_of(self.configuration, self.modal.free), symbolic=self.symbolic)

    def about(self, configuration: "Configuration", free: int = 0) -> "Problem":
        """The same scene about another of its equilibria; `free`: in how many directions it moves freely there."""
        return self._copy(modal=_modes_of(configuration, free), end=None)

    def _copy(self, **changes: Any) -> "Problem":
        kept: dict[str, Any] = {"spec": self.spec, "modal": self.modal, "choice": self.choice, "earlier": self.earlier,
                                "end": self.end, "signed": self.signed, "rough": self.rough, "digits": self.digits}
        return Problem(**{**kept, **changes})

    def case(self, name: str) -> "Problem":
        """The problem of a case of the file."""
        if name not in self._cases:
            given = {key: value for key, value in self.given.items() if key not in self.spec.choices}
            self._cases[name] = Problem(self.spec.cases[name], given, self.work)
        return self._cases[name]

    def draw(self) -> "list[Scene]":
        """Build the scene and its cases, asked or not: SpecError where the geometry contradicts itself."""
        systems = [problem.system for problem in (self, *(self.case(name) for name in self.spec.cases))]
        systems += [system.preloaded for system in systems if system.preloaded is not None]
        return [system.scene for system in systems]

    @cached_property
    def initial(self) -> "InitialState":
        from vibcli.mechanics.initial_state import InitialState

        return InitialState(self.configuration)

    @Stage
    def closed_forms(self) -> "ClosedForms | None":
        """Natural frequencies and modes in letters, by SymPy."""
        from vibcli.analyses.closed_form.modes import closed_forms

        with self.work.task("the search for closed forms"):
            return closed_forms(self.symbolic, self.modal)

    @Stage
    def equilibria(self) -> "Equilibria":
        """All equilibria within the bounds of the file, or within default ones."""
        from vibcli.mechanics.equilibrium.all_equilibria import find_equilibria
        from vibcli.mechanics.factored_system import require_dense

        require_dense(len(self.scene.q), "the search for equilibria")
        return find_equilibria(self.configuration)

    @cached_property
    def about_each(self) -> "list[Problem]":
        """The Problems about all equilibria."""
        from vibcli.mechanics.equilibrium.degenerate import about

        forces = self.equilibria.forces
        return [self.about(about(self.configuration, item, forces), len(item.free)) for item in self.equilibria.items]

    @Stage
    def response(self) -> Any:
        """The motion in time, as `motion:` of the file says: a Response of the kind that this asks for."""
        from vibcli.results.kinds_of_motion import motion_in_time

        return motion_in_time(self)

    def response_of(self, tree: "QuantityRef") -> Any:
        """The motion that a quantity of a signal is read off: where of members that vibrate the steady state alone is
        asked, that by itself, which needs no modes."""
        of_steady = any(getattr(arg, "head", "") == "steady" for arg in tree.args[:1])
        steady = self._kept_up if (of_steady or tree.head in STEADY) and self.scene.pieces else None
        return self.response if steady is None else steady

    @cached_property
    def _kept_up(self) -> "SteadyResponse | None":
        from vibcli.results.kinds_of_motion import kept_up_by_loads

        return kept_up_by_loads(self)

    @cached_property
    def free_motions(self) -> "FreeMotions":
        from vibcli.results.free_motions import FreeMotions

        return FreeMotions(self)

    @cached_property
    def phase_plane(self) -> "PhasePlane":
        """Its phase plane, of one degree of freedom."""
        from vibcli.results.phase_plane import PhasePlane

        return PhasePlane(self)

    def limit_loads(self, name: str) -> "LimitLoads":
        from vibcli.results.limit_loads import LimitLoads

        if name not in self._limits:
            self._limits[name] = LimitLoads(self, name)
        return self._limits[name]

    def require_no_members(self) -> None:
        """NotInLetters of motions in time, and at a frequency, of members that vibrate."""
        if self.scene.pieces:
            raise NotInLetters("motions of members that vibrate are found in numbers",
                               "give the parameters values with --set")

    def symbolic_frequency_response(self, signal: "LinearSignal | str", driver: str,
                                    frequency: "str | Node" = "Omega") -> "Formula":
        """The Formula of a frequency response; `frequency`: its letter, or an expression for it."""
        from vibcli.analyses.closed_form.frequency_response import formula

        self.require_no_members()
        return formula(self.symbolic, signal, driver, frequency)

    def symbolic_steady_state(self, signal: "str | Tree") -> "Steady":
        """The Steady state of a signal, or of a sum of signals, in letters."""
        from vibcli.analyses.closed_form.steady_state import steady_state

        self.require_no_members()
        return steady_state(self.symbolic, signal)

    def symbolic_following(self, signal: "str | Tree", alone: bool = False) -> "Node":
        """What of a signal follows loads that are powers of the time, in letters, counted from equilibrium; `alone`:
        where that is all in the end, NotInLetters where the free motion does not die out."""
        from vibcli.analyses.closed_form.powers_of_time import following, require_damped

        self.require_no_members()
        if alone:
            require_damped(self.symbolic)
        return following(self.symbolic, signal)

    def frequency_response(self, signal: str, driver: str) -> "FrequencyResponse":
        """The FrequencyResponse of a signal to an input."""
        from vibcli.results.frequency_response import FrequencyResponse

        if (signal, driver) not in self._curves:
            self._curves[signal, driver] = FrequencyResponse(self, signal, driver)
        return self._curves[signal, driver]


def _modes_of(configuration: "Configuration", free: int = 0, known: "KnownModes" = (None, None)) -> "ModalAnalysis":
    """The ModalAnalysis of a Configuration."""
    from vibcli.analyses.modal.modal_analysis import ModalAnalysis

    return ModalAnalysis(configuration, free, known)
