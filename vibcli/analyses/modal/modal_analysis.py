"""The modes of a system about one of its equilibria, and what is derived from them."""

from collections.abc import Callable
from functools import cached_property, partial
from importlib import import_module
from typing import TYPE_CHECKING, Any

from vibcli.analyses import ANALYSES
from vibcli.analyses.modal.mode_sequence import Modes
from vibcli.base.errors import PhysicsError
from vibcli.base.stage import Stage
from vibcli.mechanics.factored_system import MOST_DENSE, require_dense

if TYPE_CHECKING:
    import mpmath

    from vibcli.analyses.continuous.member_damping import MemberDamping
    from vibcli.analyses.continuous.mode_fields import ModeFields
    from vibcli.analyses.modal.damped_modes import DampedMode
    from vibcli.analyses.modal.stability import Stability
    from vibcli.analyses.modal.undamped import Mode
    from vibcli.base.errors import T
    from vibcli.mechanics.configuration import Configuration
    from vibcli.mechanics.factored_system import FactoredSystem
    from vibcli.scene.scene import Scene

MOST, MORE = 10_000, 20     # steps of a million products; digits beyond those that are asked


class ModalAnalysis:
    """The modes of a Configuration. `free`: the number of directions in which it is known to move freely, where it is
    one of a family of equilibria; `known`: modes that are known, natural ones and damped ones, else None."""

    def __init__(self, configuration: "Configuration", free: int = 0, known: tuple[Any, Any] = (None, None)) -> None:
        self.configuration, self.free, self._known = configuration, free, known
        self.numeric, self.system, self.spec = configuration.numeric, configuration.system, configuration.spec
        self.work, self.costs, self._results, self._scales = configuration.work, configuration.costs, {}, {}
        self._fields: dict[int, ModeFields] = {}

    @cached_property
    def scene(self) -> "Scene":
        found: Scene = self.system.scene
        return found

    def once(self, what: str, find: Callable[[], Any]) -> Any:
        """What `find()` gives, found once of these modes."""
        if what not in self._results:
            self._results[what] = find()
        return self._results[what]

    @Stage[Any]     # of modes of one kind
    def modes(self) -> Modes:
        """The modes of the system without its dampers; none where it would not oscillate."""
        if self._known[0] is not None:
            return Modes(self._known[0])
        from vibcli.analyses.modal.modes import chosen_at_limit, natural_modes

        elements = self._natural_data
        if elements.massless and not elements.pieces:
            from vibcli.analyses.modal.massless_coordinates import only_damped

            if only_damped(elements):
                return Modes([])
        return self._sequence(self.solved(natural_modes, elements, *self.configuration.sources,
                                          at_limit=chosen_at_limit(self.spec)))

    @cached_property
    def zero_modes(self) -> dict[int, str]:
        """What each mode without frequency is: free, held or falling (mechanics/equilibrium/zero_modes.py)."""
        rigid = [mode for mode in self.modes.shown() if mode.rigid]
        if not rigid:
            return {}
        from vibcli.mechanics.equilibrium.zero_modes import FREE, zero_modes

        if len(rigid) == self.free:
            return dict.fromkeys((mode.index for mode in rigid), FREE)
        return zero_modes(self.configuration, rigid)

    @property
    def many(self) -> bool:
        """Are there so many coordinates that the lowest modes alone are found?"""
        return len(self.scene.q) > MOST_DENSE

    @property
    def _natural_data(self) -> "FactoredSystem":
        """The element data that natural modes are found of; of many coordinates without what `damping:` adds."""
        given = self.many and self.spec.get("damping") is not None
        return self.configuration.without_given_damping() if given else self.configuration.element_data

    @property
    def damps(self) -> bool:
        """Does anything depend on velocities?"""
        return (self.many and self.spec.get("damping") is not None) or self.configuration.element_data.damps

    @Stage[Any]
    def damped(self) -> Modes | None:
        """The damped modes; None where nothing damps."""
        if self._known[1] is not None:
            return Modes(self._known[1])
        if self.member_damping is not None:
            return self._rated(self.modes, self.member_damping)
        if not self.damps:
            return None
        require_dense(len(self.scene.q), "the search for damped modes")
        elements = self.configuration.element_data
        from vibcli.analyses.modal.modes import damped_modes

        return self._sequence(self.solved(damped_modes, elements, lambda: self.modes, *self.configuration.sources))

    @cached_property
    def member_damping(self) -> "MemberDamping | None":
        """What `damping:` gives to the modes of members with inertia, each by itself; None where nothing is given, or
        what else damps couples them."""
        if self.spec.get("damping") is None or not self.scene.pieces or self.modes.finite or self.configuration.coupled:
            return None
        from vibcli.analyses.continuous.member_damping import member_damping
        from vibcli.symbolic.evaluation import Floats

        found = member_damping(self.configuration, self.modes, Floats)
        return None if found is None or found.nothing else found

    def _rated(self, modes: Modes, damping: "MemberDamping", digits: int | None = None) -> Modes:
        """The damped modes of members whose modes are damped each by itself."""
        if self.configuration.rated_beside_dampers:
            from vibcli.analyses.continuous.rated_source import RatedDampedModes

            return self._sequence(RatedDampedModes(self.configuration.linear_system, self.modes, damping))
        from vibcli.analyses.continuous.rated_modes import RatedModes

        return Modes((), RatedModes(modes, damping, digits), self.solved)

    def _sequence(self, found: Any) -> Modes | None:
        """The Modes of a list of them, or of what finds modes without end; None of None."""
        return None if found is None else Modes(found) if isinstance(found, list) else Modes((), found, self.solved)

    @cached_property
    def stability(self) -> "Stability":
        """The Stability of the equilibrium."""
        from vibcli.analyses.modal.stability import stability

        return stability(self)

    @cached_property
    def margins_without_inertia(self) -> tuple[list[float], float]:
        """What passes through zero at the limit of stability where coordinates have no inertia."""
        from vibcli.analyses.modal.stability_of_stiffness import margins

        return margins(self)

    @cached_property
    def slow_squares(self) -> Any:
        """Of members: rigid motions, and about ω² of the slowest others (continuous/slow_motions.py)."""
        from vibcli.analyses.continuous.slow_motions import slow_squares

        return self.solved(slow_squares, self.configuration.linear_system)

    def shape(self, mode: "DampedMode | Mode", how: str = "first") -> "list[complex | mpmath.mpf]":
        """The shape of a mode in the normalisation asked for, as a list of numbers."""
        from vibcli.analyses.modal.normalisation import cleaned, normalised

        told = self.told_apart(mode)
        if not self.scene.members or not hasattr(mode, "motion"):
            return normalised(told.shape, how, self._weights)
        factor = self.scale(told, how)
        found = [x * factor for x in told.shape]
        return [cleaned(x if told is mode else complex(x) if x.imag else float(x.real)) for x in found]

    @cached_property
    def _weights(self) -> list[float]:
        """Of each coordinate, by which amplitudes of different units are compared."""
        from vibcli.analyses.modal.normalisation import weights

        return weights(self._natural_data)

    def told_apart(self, mode: Any) -> "Mode":
        """A Mode in more digits where another frequency is so close that its shape in floats is a mix of both."""
        from vibcli.analyses.modal import close_shapes

        found: Mode = close_shapes.told_apart(self, mode)
        return found

    def apart(self, mode: "DampedMode | Mode") -> float:
        """How far the eigenvalue of a mode is from the next, in parts of it, where its shape loses digits by that."""
        from vibcli.analyses.modal import close_shapes

        return close_shapes.apart(self, mode)

    def scale(self, mode: Any, how: str = "first") -> "float | mpmath.mpf":
        """What the shape of a Mode of a scene with members, of unit modal mass, is multiplied by."""
        if (id(mode), how) not in self._scales:
            self._scales[id(mode), how] = mode, self.fields(mode).scale(how, self._weights, len(self.spec.coordinates))
        return self._scales[id(mode), how][1]

    def fields(self, mode: Any) -> "ModeFields":
        """The ModeFields of a mode, in its numbers."""
        from vibcli.analyses.continuous.mode_fields import ModeFields
        from vibcli.symbolic.evaluation import Floats

        if isinstance(mode.error, float) and isinstance(mode.omega or mode.growth_rate or 0.0, float):
            if id(mode) not in self._fields:
                self._fields[id(mode)] = ModeFields(mode, self.scene.resting, Floats, self.configuration.at_rest)
            return self._fields[id(mode)]
        from mpmath import mp

        return ModeFields(mode, self.scene.resting, *self.configuration.precise_rest(mp.dps), mp.mpf)

    def solved(self, solve: "Callable[..., T]", *args: Any, **options: Any) -> "T":
        """What solves for modes, as a task; its refusals have the names of coordinates."""
        from vibcli.analyses.modal.scaling import UnheldCoordinate

        try:
            with self.work.task("the search for the modes", MOST):
                return solve(*args, **options)
        except UnheldCoordinate as error:
            name = self.scene.coordinates[error.number]
            owner = next((member for member in self.scene.members if name.startswith(f"{member}.")), None)
            raise error.named(name, self.spec.origin(name).where, not self.spec.dimensions.of(name), owner) from None

    def steps_to_digits(self, digits: int) -> float:
        """About how many steps of a million products so many digits take, before anything is computed."""
        from vibcli.numerics.precision import estimated_steps

        damped = any(section in self.spec.sections for section in ("dampers", "damping", "energies", "matrices"))
        return estimated_steps(len(self.spec.coordinates), digits, damped)

    def modes_to(self, digits: int) -> Modes:
        """The modes of the system without its dampers, recomputed to so many correct digits; found once."""
        from vibcli.analyses.modal.modes import chosen_at_limit, natural_modes

        return self._sharpened("modes", digits, partial(natural_modes, at_limit=chosen_at_limit(self.spec))) if (
            self.modes) else self.modes

    def damped_to(self, digits: int) -> Modes | None:
        """The damped modes, recomputed; None where nothing damps."""
        if self.member_damping is not None:
            return self._rated_to(digits)
        from vibcli.analyses.modal.modes import damped_modes

        return self._sharpened("damped", digits, damped_modes, lambda: self.modes_to(digits))

    def _rated_to(self, digits: int) -> Modes:
        """The damped modes of members whose modes are damped each by itself, to so many digits."""
        if self.configuration.rated_beside_dampers:
            raise PhysicsError("damped modes of members with distributed inertia are found in floats alone",
                               "leave --digits out, or take out what damps")
        from mpmath import mp

        from vibcli.analyses.continuous.member_damping import member_damping
        from vibcli.symbolic.evaluation import multiprecision

        with mp.workdps(digits + MORE):
            damping = member_damping(self.configuration, self.modes_to(digits), multiprecision())
        return self._rated(self.modes_to(digits), damping, digits)

    def _sharpened(self, word: str, digits: int, solve: Callable[..., Any], *natural: Callable[..., Any]) -> Modes:
        found: Modes = self.once(f"{word} to {digits} digits", lambda: self._sharp(digits, solve, *natural))
        return found

    def _sharp(self, digits: int, solve: Callable[..., Any], *natural: Callable[..., Any]) -> Modes:
        elements, sources = self.configuration.linear_system, self.configuration.sources
        if (settled := self.system.settled) is not None and settled.names:
            raise PhysicsError(f"the tension of '{settled.names[0]}', found in equilibrium, is known to the digits of "
                               "floats: no more of what depends on it are found", "leave --digits out")
        if sources[0] is None:
            from vibcli.mechanics.high_precision import Degenerate

            raise Degenerate
        return self._sequence(self.solved(solve, elements, *natural, *sources, digits=digits))

    @cached_property
    def sharp_modes(self) -> "list[Mode]":
        """The modes to the digits that shares and derivatives need."""
        from vibcli.analyses.modal.modes_precise import sharp_modes

        require_dense(self.configuration.element_data.n)
        if not self.modes.finite:
            raise PhysicsError("shares and sensitivities are found where there are finitely many modes; a member "
                               "with distributed inertia has modes without end",
                               "see `vibcli frequencies` for the modes themselves")
        return self.solved(sharp_modes, self.configuration)

    @cached_property
    def sharp_damped(self) -> "list[DampedMode]":
        """The damped modes to as many digits; asked for only where something damps."""
        from vibcli.analyses.modal.modes_precise import sharp_damped

        return self.solved(sharp_damped, self.configuration, lambda: self.sharp_modes)

    def rayleigh_quotient(self, deflection: str, digits: int | None) -> "mpmath.mpf":
        """Rayleigh's quotient of a scene with one member, whose deflection is a function of the place x."""
        from vibcli.analyses.continuous.assumed_bounds import quotient

        return self.costs.measured("rayleigh", lambda: quotient(self, deflection, digits))

    def result(self, word: str) -> Any:
        """What the analysis of a word of `find` finds of these modes, as the file asks for it; found once."""
        questions = self.spec.get("find")
        asked = None if questions is None else questions.about(word)
        find = getattr(import_module("vibcli.analyses." + ANALYSES[word][0].replace("/", ".")), word)
        return self.once(word, lambda: self.costs.measured(word, lambda: find(self, asked)))
