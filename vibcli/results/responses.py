"""The motion of a scene in time, of its small oscillations exactly or of its full equations, and the signals of it.

A signal is an expression of coordinates, places, forces (vibcli/language/signals.py) and parameters. A sum of them with
constant factors is exact at any time; products and powers are evaluated instant by instant, their extremes refined.
"""

from collections.abc import Callable, Iterable, Mapping
from functools import cached_property
from typing import TYPE_CHECKING, Any, cast

from vibcli.analyses.excitation.linear_output import LinearOutput, combined
from vibcli.language.signals import ENERGIES
from vibcli.results.closing import Closing
from vibcli.results.given_start import check_start
from vibcli.results.response import Response
from vibcli.results.signal_nodes import node_of_signal
from vibcli.results.signals import ComposedSignal, LinearSignal
from vibcli.symbolic.derivatives import gradient, substitute
from vibcli.symbolic.evaluation import Floats, evaluate
from vibcli.symbolic.expression_graph import reachable
from vibcli.symbolic.rationals import fraction_of
from vibcli.symbolic.syntax import NameRef, QuantityRef

if TYPE_CHECKING:
    import mpmath
    import numpy as np

    from vibcli.analyses.excitation.forcing import Forcing
    from vibcli.analyses.modal.mode_sequence import Modes
    from vibcli.analyses.transient.data_errors import DataErrors
    from vibcli.analyses.transient.linear_response import LinearMotion
    from vibcli.results.precise_response import PreciseResponse
    from vibcli.results.problem import Problem
    from vibcli.results.signal import Signal
    from vibcli.symbolic.node import Node
    from vibcli.symbolic.syntax import SyntaxTree

    Read = tuple[LinearOutput, Node | None]         # off the motion, and what moves by itself
    PartOfSignal = Read | tuple[QuantityRef]
    Terms = list[tuple[float | mpmath.mpf, Read]]   # (factor, what is read)


def _jumps(node: "Node", symbols: "Iterable[Node]") -> bool:
    """Does a function stand in the node that has no slope but where it jumps, of one of these symbols?"""
    return any(part.name == "sign" and any(part.mask & symbol.mask for symbol in symbols) for part in reachable([node]))


class SmallResponse(Response):
    """Small oscillations about the equilibrium, exact in time. finely: what makes a PreciseResponse of a Problem."""

    KIND, WORDS = "small", "small oscillations about the equilibrium"
    arithmetic: Any = Floats

    def __init__(self, problem: "Problem", finely: "Callable[[Problem], PreciseResponse] | None" = None) -> None:
        super().__init__(problem)
        self.configuration, self.finely, self.finer = problem.configuration, finely, {}
        self._moved: dict[tuple[Node, ...], LinearMotion] = {}      # by what of them depends on the time alone
        self._outputs: dict[str, tuple[LinearOutput, Node | None]] = {}
        self._signals: dict[Node, Signal] = {}

    @cached_property
    def values(self) -> dict[str, Any]:
        """{parameter: number}."""
        return self.problem.numeric.floats

    @property
    def precise(self) -> "PreciseResponse":
        """The PreciseResponse at the working precision of mpmath."""
        from mpmath import mp

        if mp.prec not in self.finer:
            self.finer[mp.prec] = self.finely(self.problem)
        return cast("PreciseResponse", self.finer[mp.prec])

    @property
    def known(self) -> float:
        return self.until

    @cached_property
    def deviations(self) -> "tuple[np.ndarray, np.ndarray]":
        """(q, v) at t = 0, counted from the equilibrium, as arrays."""
        import numpy as np

        places, speeds = self.problem.initial.start
        rest = self.problem.configuration.equilibrium.values
        names = self.problem.scene.coordinates
        return (np.array([places[name] - rest[name] for name in names]), np.array([speeds[name] for name in names]))

    @cached_property
    def data_errors(self) -> "DataErrors":
        """The DataErrors of the matrices and of the start."""
        import numpy as np

        from vibcli.analyses.transient.data_errors import of_elements
        from vibcli.symbolic.running_errors import error_in

        configuration, names = self.problem.configuration, self.problem.scene.coordinates
        _, known = configuration.bounded_rest
        rest = np.array([float(error_in(known[name])) for name in names])
        places, speeds = (np.array([part[name] for name in names]) for part in self.problem.initial.start)
        return of_elements(configuration.linear_system, self.matrices, (places, speeds), rest)

    @cached_property
    def matrices(self) -> "tuple[np.ndarray, np.ndarray, np.ndarray]":
        """M, C + G, K as arrays."""
        return self.problem.configuration.linear_system.coefficients()

    def forcing(self, direct: Any = ()) -> "Forcing":
        """The Forcing of the coordinates; `direct`: nodes of the time on further channels."""
        from vibcli.analyses.excitation.decompose import forcing_of
        from vibcli.notation.plain import plain

        n = len(self.matrices[0])
        nodes = {**self.drive, **{n + number: node for number, node in enumerate(direct)}}
        return forcing_of(nodes, self.problem.scene.time, self.problem.numeric.floats, n + len(direct), write=plain,
                          work=self.problem.work)

    def moved(self, direct: Any = ()) -> "LinearMotion":
        """The LinearMotion under the excitation."""
        from vibcli.analyses.transient.linear_response import linear_motion

        found = self.problem.modal.solved(linear_motion, *self.matrices, self.forcing(direct), *self.deviations,
                                          modes=self.modes, work=self.problem.work, doubt=lambda: self.data_errors,
                                          rigid=self.rigid)
        check_start(self.problem, found)
        return found

    @property
    def start(self) -> tuple[dict[str, float], dict[str, float]]:
        """The start, and where what has no inertia stands then."""
        places, speeds = self.problem.initial.start
        if self.alone.system is None:
            return places, speeds
        rest = self.problem.configuration.equilibrium.values
        return {name: rest[name] + float(x) for name, x in zip(places, self.alone.start, strict=True)}, speeds

    @cached_property
    def modes(self) -> "Modes | None":
        """The undamped modes, which the element data tell better than K; None where they are not real."""
        elements = self.problem.configuration.linear_system
        if elements.G or elements.circulatory or elements.massless:
            return None
        return cast("Modes | None", self.problem.modal.modes)

    @cached_property
    def rigid(self) -> "np.ndarray | None":
        """Columns of what moves freely; None where turning frames or circulatory forces make modes complex."""
        import numpy as np

        elements = self.problem.configuration.linear_system
        if elements.G or elements.circulatory or len(elements.massless) == elements.n:
            return None
        shapes = [[float(x) for x in mode.shape] for mode in self.problem.modal.modes if mode.rigid]
        return np.array(shapes).reshape(len(shapes), elements.n).T

    @cached_property
    def alone(self) -> "LinearMotion":
        return self.moved()

    @property
    def is_followed(self) -> bool:
        """Was the motion found, and looked at from its start on?"""
        return "alone" in vars(self) and self.alone.is_followed

    def lasting(self) -> float:
        from vibcli.analyses.transient.duration import duration, fading

        problem, forcing = self.problem, self.alone.forcing
        last = forcing.last.start if forcing.listed else 0.0
        modes = () if problem.modal.damped or not self.alone.blocks else problem.modal.modes.shown()
        damped = problem.modal.damped and problem.modal.damped.shown()
        return duration(modes, damped, last, sorted(forcing.speeds), fading(forcing))

    def signal(self, tree: "SyntaxTree") -> "Signal":
        """The signal of a tree, one for all that is asked of it."""
        parts: dict[Node, PartOfSignal] = {}
        node = node_of_signal(tree, self.problem.scene.table, lambda *named: self._part(parts, *named))
        if node not in self._signals:
            self._signals[node] = self._of_node(node, parts, (self, tree))
        return self._signals[node]

    def _of_node(self, node: "Node", parts: "Mapping[Node, PartOfSignal]", source: tuple[Any, ...]) -> "Signal":
        if node in parts:
            return cast("Signal", self._one(parts[node], source))
        slopes = gradient(node)
        outputs = {symbol: part for symbol, part in parts.items() if len(part) == 2}
        if any(slope.mask for slope in slopes.values()) or _jumps(node, parts) or len(outputs) < len(parts):
            return self._composed(node, parts, source)
        used = [symbol for symbol in outputs if symbol in slopes]
        values = {**self.values, **{symbol.name: 0.0 for symbol in parts}}
        constant, *factors = evaluate([node, *(slopes[symbol] for symbol in used)], self.arithmetic, values)
        return self._linear(constant, list(zip(factors, (outputs[symbol] for symbol in used), strict=True)), source)

    def _part(self, parts: "dict[Node, PartOfSignal]", name: str, primes: int,
              part: "SyntaxTree | tuple[str]") -> "Node":
        """The node of a name within a signal; a symbol for what is read off the motion."""
        from vibcli.analyses.excitation.signal_outputs import quadratic_output
        from vibcli.mechanics.inputs_outputs.outputs import is_quadratic

        problem, table = self.problem, self.problem.scene.table
        if name in problem.scene.parameters.nodes and not primes:
            return problem.scene.parameters.nodes[name]
        text = "signal " + (part.text if isinstance(part, QuantityRef) else name + "'" * primes)
        if isinstance(part, QuantityRef):
            return self._named(parts, text, (part,))
        if name in ENERGIES and name not in problem.spec.coordinates:
            from vibcli.mechanics.signals import energy

            return self._at_states(parts, energy(problem.scene, name, primes))
        if is_quadratic(name):
            total = table.zero
            for number, (weight, (one, two)) in enumerate(quadratic_output(self.configuration, name, primes)):
                first, second = (self._named(parts, f"{text} {number}{mark}", self._apart(*found))
                                 for mark, found in (("", one), ("'", two)))
                total = total + first * second * table.number(fraction_of(weight))
            return total
        return self._named(parts, text, self._output(name + "'" * primes))

    def _output(self, name: str) -> "tuple[LinearOutput, Node | None]":
        """(Output, node on its channel or None) of what is a linear function of the motion."""
        from vibcli.analyses.excitation.signal_outputs import linear_output

        if name not in self._outputs:
            self._outputs[name] = self._apart(*linear_output(self.configuration, name))
        return self._outputs[name]

    def _named(self, parts: "dict[Node, PartOfSignal]", text: str, found: "PartOfSignal") -> "Node":
        """The symbol of what is read off the motion: of what is there already that which it has, so that equals
        cancel."""
        symbol = next((symbol for symbol, known in parts.items() if known == found), None)
        if symbol is None:
            symbol = self.problem.scene.table.variable(text)
            parts[symbol] = found
        return symbol

    def state_signal(self, node: "Node") -> ComposedSignal:
        """The signal of an expression of coordinates, velocities and accelerations."""
        parts: dict[Node, PartOfSignal] = {}
        return self._composed(self._at_states(parts, node), parts)

    def _composed(self, node: "Node", parts: "Mapping[Node, PartOfSignal]",
                  source: tuple[Any, ...] = ()) -> ComposedSignal:
        """The function `node` of the signals of `parts`, and of coordinates that close loops where it holds some."""
        signals = {symbol.name: self._one(part) for symbol, part in parts.items()}
        return ComposedSignal(node, signals, self.values, self.problem.scene.time, self._closing(node),
                              self.problem.work, source)

    def _closing(self, node: "Node") -> Closing | None:
        scene = self.problem.scene
        if scene.loops is None or not any(part.op == "symbol" and part.name in scene.loops.names
                                          for part in reachable([node])):
            return None
        return Closing(scene.loops, self.configuration.at_rest,
                       {q: self.signal(NameRef(0, 0, q, 0)) for q in scene.coordinates})

    def _at_states(self, parts: dict[Any, Any], node: "Node") -> "Node":
        """The same with the coordinates and their rates replaced by symbols of their signals."""
        scene = self.problem.scene
        states = {symbol: (name, primes) for primes, kind in enumerate((scene.q, scene.v, scene.a))
                  for symbol, name in zip(kind, scene.coordinates, strict=True)}
        below = set(reachable([node]))
        return substitute([node], {symbol: self._part(parts, name, primes, ("name",))
                                   for symbol, (name, primes) in states.items() if symbol in below})[0]

    def _apart(self, output: LinearOutput, direct: "Mapping[int, Node]") -> "tuple[LinearOutput, Node | None]":
        """(Output without its channel, the node on it or None)."""
        from vibcli.symbolic.transfer_between_tables import copied

        nodes = copied(list(direct.values()), self.problem.scene.table)
        return output._replace(channels={}), next(iter(nodes), None)

    def _one(self, part: "PartOfSignal", source: tuple[Any, ...] = ()) -> Any:
        if len(part) == 2:
            return self._linear(0.0, [(1.0, part)], source)
        return getattr(self.signal(part[0].args[0]), part[0].head)

    def _linear(self, constant: float, terms: "Terms", source: tuple[Any, ...] = ()) -> LinearSignal:
        motion, output = self._driven(constant, terms)
        return LinearSignal(motion, output, source=source)

    def _driven(self, constant: float, terms: "Terms", ) -> tuple[Any, LinearOutput]:
        """(motion, output) of a constant and of terms [(factor, (output, node of the time or None))]."""
        direct = tuple(node for _, (_, node) in terms if node is not None)
        if direct and direct not in self._moved:
            self._moved[direct] = self.moved(direct)
        motion = self._moved[direct] if direct else self.alone
        channel, outputs = len(self.matrices[0]), [(1.0, LinearOutput(constant))]
        for factor, (output, node) in terms:
            if node is not None:
                output = output._replace(channels={channel: 1.0})
                channel += 1
            outputs.append((factor, output))
        return motion, combined(outputs)
