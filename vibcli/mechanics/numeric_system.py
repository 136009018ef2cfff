"""A mechanical system with numbers for its parameters, before it rests anywhere."""

from collections.abc import Mapping
from functools import cached_property
from math import isfinite
from typing import TYPE_CHECKING, Any

from vibcli.base.errors import Kinked, PhysicsError
from vibcli.base.stage import Costs
from vibcli.symbolic.evaluation import Floats, evaluate

if TYPE_CHECKING:
    from fractions import Fraction

    from vibcli.mechanics.compiled_statics import StaticForces
    from vibcli.mechanics.numeric_linearisation import Numbers
    from vibcli.mechanics.system import MechanicalSystem
    from vibcli.scene.closed_loops import Loops
    from vibcli.scene.scene import Scene

LOST, BESIDE = 1e-12, 1e-3      # relative: rounding of what is left of forces; of the size of the figure


class NumericSystem:
    """`given`: exact values for parameters that the file leaves as symbols; `floats`: {parameter: float}, and `drawn`:
    {coordinate: float} as drawn, where these are known."""

    def __init__(self, system: "MechanicalSystem", given: "Mapping[str, Fraction] | None" = None,
                 floats: dict[str, float] | None = None, drawn: dict[str, float] | None = None) -> None:
        self.system, self.spec, self.work = system, system.spec, system.work
        self.given, self.costs = (system.given, system.costs) if given is None else (given, Costs())
        if floats is not None:
            self.floats, self.has_free_symbols = floats, False
        if drawn is not None:
            self.drawn_floats = drawn

    @cached_property
    def scene(self) -> "Scene":
        return self.system.scene

    def with_values(self, given: "Mapping[str, Fraction]") -> "NumericSystem":
        """The same with values for its symbols, its scene drawn anew."""
        return NumericSystem(self.system.with_values({**self.given, **given}))

    def sharing(self, given: "Mapping[str, Fraction]") -> "NumericSystem":
        """The same with the expressions of this scene: for values on which no sign in its geometry hangs; drawn anew
        where tensions of members are to be found."""
        from vibcli.scene.member_tensions import statics_tells

        if self.system.settled is not None and not statics_tells(self.scene):
            return self.with_values(given)
        return NumericSystem(self.system, {**self.given, **given})

    @cached_property
    def has_free_symbols(self) -> bool:
        """Are there parameters without value?"""
        return any(name not in self.given for name in self.scene.parameters.free)

    def values(self, arithmetic: Any) -> dict[str, Any]:
        """{parameter: number} in an arithmetic."""
        from vibcli.language.parameters import require_values

        if self.has_free_symbols:
            require_values(self.scene.parameters, "this")
        given = {name: arithmetic.number(value) for name, value in self.given.items()}
        return self.scene.parameters.values(arithmetic, given)

    @cached_property
    def floats(self) -> dict[str, float]:
        return self.values(Floats)

    @cached_property
    def rounded(self) -> dict[str, Any]:
        """The same with the bounds of their rounding."""
        from vibcli.symbolic.running_errors import RunningErrors

        return self.values(RunningErrors(Floats))

    @cached_property
    def drawn_floats(self) -> dict[str, float]:
        drawn = {q.name: node for q, node in self.scene.drawn.items()}
        drawn = {name: drawn[name] for name in (*self.spec.coordinates, *self.scene.hidden) if name in drawn}
        return dict(zip(drawn, evaluate(list(drawn.values()), Floats, self.floats), strict=True))

    @cached_property
    def rational(self) -> "Mapping[str, Fraction]":
        """Exact values of the parameters that have a rational one."""
        return self.scene.parameters.rational(self.given)

    @cached_property
    def figure_size(self) -> float:
        """The extent of the drawn figure in metres; 0 where nothing has a place."""
        return self.scene.extent({**self.floats, **self.drawn_floats})

    def size_along(self, coordinate: str) -> float:
        """The size of the figure along a coordinate: 1 of an angle."""
        return (self.figure_size or 1.0) if self.system.dimension(coordinate) else 1.0

    def at_rest_in(self, position: Mapping[str, float]) -> dict[str, float]:
        """{symbol: float} of everything at rest in a position, at t = 0."""
        return {**self.floats, self.scene.time.name: 0.0, **position, **{v.name: 0.0 for v in self.scene.v}}

    @cached_property
    def static_forces(self) -> "StaticForces":
        """r, the sizes of its terms and K in floats."""
        from vibcli.mechanics.compiled_statics import StaticForces

        return StaticForces(self)

    @cached_property
    def drawn_numbers(self) -> "Numbers | None":
        """The Numbers in the drawn position where that is an equilibrium, else None."""
        from vibcli.mechanics.equilibrium.equilibrium import is_balanced
        from vibcli.mechanics.numeric_linearisation import in_numbers

        try:
            form = self.system.linearisation_at_reference
        except Kinked:          # the slope of a force is infinite there
            if not any(self.left_as_drawn):
                raise
            return None
        numbers = in_numbers(form, Floats, self.floats, self.rational)
        return numbers if is_balanced(numbers, len(form.curved) + len(form.residual) + 2) else None

    @property
    def left_as_drawn(self) -> list[float]:
        """What is left of the forces along each coordinate in the drawn position; 0 where that may be rounding."""
        found = [evaluate(terms, Floats, self.floats) for terms in self.system.drawn_residual]
        return [sum(terms) if abs(sum(terms)) > LOST * sum(map(abs, terms)) else 0.0 for terms in found]

    def beside_drawn(self) -> dict[str, float]:
        """The drawn position moved a little the way that its forces drive it, each coordinate by another share, those
        too that no force drives: where their slopes may be finite, of what is between two of them too."""
        pushes = dict(zip(self.scene.coordinates, self.left_as_drawn, strict=True))
        senses = {name: (push > 0) - (push < 0) for name, push in pushes.items()}
        first = next(filter(None, senses.values()), 0)
        senses = {name: sense or first for name, sense in senses.items()}
        return {name: x - BESIDE * self.size_along(name) * senses.get(name, 0) * (1 - 0.618 * i % 0.9)
                for i, (name, x) in enumerate(self.drawn_floats.items())}

    def start(self) -> dict[str, float]:
        """The position from which the equilibrium is searched: as drawn but for what is named."""
        start = self.system.named_start
        values = evaluate(list(start.values()), Floats, self.floats)
        for name, value in zip(start, values, strict=True):
            if not isfinite(value):
                raise PhysicsError(f"the start of '{name}' is no real number", "name another place under "
                                   "`equilibrium:`", self.spec.get("equilibrium")[name].where)
        return self.closed(self.drawn_floats, {**self.drawn_floats, **dict(zip(start, values, strict=True))})

    def closed(self, start: Mapping[str, float], target: dict[str, float]) -> dict[str, float]:
        """The position at rest `target` ({coordinate: float}) with its dependent coordinates, reached from the closed
        position `start`; PhysicsError where its loops cannot close there."""
        return self._followed(self.scene.resting.loops, start, target)

    def closed_at_start(self, start: Mapping[str, float], target: dict[str, float]) -> dict[str, float]:
        """The same with what is driven to and fro where it is at t = 0."""
        return self._followed(self.scene.loops, start, target)

    def _followed(self, loops: "Loops | None", start: Mapping[str, float],
                  target: dict[str, float]) -> dict[str, float]:
        if loops is None:
            return target
        floats = {**self.floats, self.scene.time.name: 0.0}
        found = loops.followed({**floats, **start}, {**floats, **target})
        if found is None:
            raise PhysicsError("the loops of this scene cannot close in the position asked for",
                               "start nearer to the drawn position, or make the links longer")
        return {name: found[name] for name in self.drawn_floats}
