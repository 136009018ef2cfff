"""The motion in time of scenes with bars, shafts and strings, by the waves that travel along them."""

from functools import cached_property
from typing import TYPE_CHECKING, Any

from vibcli.analyses.excitation.linear_output import FieldPoint, LinearOutput
from vibcli.base.errors import PhysicsError
from vibcli.results.responses import SmallResponse
from vibcli.symbolic.rationals import fraction_of

if TYPE_CHECKING:
    from collections.abc import Sequence

    import numpy as np

    from vibcli.results.problem import Problem
    from vibcli.symbolic.node import Node


class WaveResponse(SmallResponse):
    """Small oscillations about the equilibrium, followed from front to front. NotByWaves where a member disperses its
    waves or loses them on their way, or where the fronts are too many."""

    KIND, WORDS = "waves", "small oscillations about the equilibrium, by travelling waves"

    def __init__(self, problem: "Problem"):
        super().__init__(problem)

    @property
    def start(self):
        return self.problem.initial.start

    @cached_property
    def matrices(self):
        """M, C + G, K without the pieces."""
        M, C, G, K = self.configuration.linear_system.with_parts(pieces=()).arrays()
        return M, C + G, K

    @cached_property
    def placed(self):
        """The PlacedPieces, their rows over coordinates and, behind them, inputs."""
        return self.configuration.with_inputs.numbers.elements.pieces

    @cached_property
    def _inputs(self):
        """{number of an input: what moves it, a node of the time} of displacements that drive the scene."""
        from vibcli.symbolic.transfer_between_tables import copied

        opened = self.configuration.with_inputs
        nodes = {i: one.node for i, one in enumerate(opened.scene.inputs.values(), opened.n) if one.node is not None}
        return dict(zip(nodes, copied(list(nodes.values()), self.problem.scene.table), strict=True))

    def _driven_by(self, row):
        """What moves the end of a piece beside the coordinates, a node of the time, or None."""
        table, n = self.problem.scene.table, self.configuration.with_inputs.n
        terms = [self._inputs[i] * table.number(fraction_of(x)) for i, x in row.items() if i >= n and x]
        return sum(terms[1:], terms[0]) if terms else None

    @cached_property
    def _ends(self):
        """[(row over coordinates, node of the time or None)] of all ends of pieces, from left to right."""
        n = self.configuration.with_inputs.n
        return [({i: float(x) for i, x in row.items() if i < n and x}, self._driven_by(row))
                for piece in self.placed for row in piece.rows]

    @cached_property
    def _loads(self):
        """{i: node of the time}: what drives the coordinates, less what the springs that pieces are at rest would bring
        from driven ends."""
        table, n, found = self.problem.scene.table, self.configuration.with_inputs.n, dict(self.drive)
        for piece in self.placed:
            for weight, row in piece.springs:
                driven = self._driven_by(row)
                for i, x in row.items() if driven is not None else ():
                    if i < n:
                        found[i] = found.get(i, table.zero) + driven * table.number(fraction_of(weight * x))
        return found

    @cached_property
    def alone(self):
        """The WaveMotion under the excitation."""
        from vibcli.analyses.continuous.travelling_waves import wave_motion
        from vibcli.analyses.continuous.travelling_waves_march import wave_piece

        channels = iter(range(len(self.matrices[0]), len(self.matrices[0]) + len(self._ends)))
        numbered = [(row, None if node is None else next(channels), node) for row, node in self._ends]
        pieces = [wave_piece(placed, *(end[:2] for end in numbered[2 * k:2 * k + 2]))
                  for k, placed in enumerate(self.placed)]
        nodes = self._loads | {channel: node for _, channel, node in numbered if channel is not None}
        return wave_motion(*self.matrices, pieces, self._forcing_of(nodes), *self.deviations, self.fields,
                           self.problem.work)

    @property
    def fields(self):
        """What each piece starts with, counted from the equilibrium, as Forcing over its length; None of those that are
        at rest, straight between their ends."""
        from vibcli.mechanics.initial_fields import member_fields

        given = member_fields(self.problem.scene)
        return [self._field(piece, given[piece.owner]) if piece.owner in given else None for piece in self.placed]

    def _field(self, piece, given):
        """u and u̇ over one piece; the time of the scene stands for the place along it."""
        from vibcli.analyses.excitation.decompose import forcing_of
        from vibcli.notation.plain import plain
        from vibcli.symbolic.derivatives import substitute

        scene, table = self.problem.scene, self.problem.scene.table
        place = scene.time + table.number(fraction_of(float(piece.start)))
        length = table.number(fraction_of(float(piece.piece.length)))
        left, right = (table.number(fraction_of(x)) for x in self._ends_at_rest(piece))
        if given.displacement is None:
            left, right = (table.number(fraction_of(sum(x * self.deviations[0][i] for i, x in row.items() if i < len(
                self.deviations[0])))) for row in piece.rows)
            nodes = {0: left + (right - left) / length * scene.time}
        else:
            nodes = {0: substitute([given.displacement], {scene.time: place})[0]
                     - (left + (right - left) / length * scene.time)}
        if given.rate is not None:
            nodes[1] = substitute([given.rate], {scene.time: place})[0]
        return forcing_of(nodes, scene.time, self.problem.numeric.floats, 2, write=plain, work=self.problem.work)

    def _ends_at_rest(self, piece):
        """The displacements of the ends of a piece in equilibrium."""
        from vibcli.symbolic.evaluation import Floats, evaluate

        term = self.problem.scene.resting.pieces[self.placed.index(piece)]
        return evaluate(list(term.s), Floats, self.configuration.at_rest)

    def _forcing_of(self, nodes):
        from vibcli.analyses.excitation.decompose import forcing_of
        from vibcli.notation.plain import plain

        count = max([len(self.matrices[0]) - 1, *nodes]) + 1
        return forcing_of(nodes, self.problem.scene.time, self.problem.numeric.floats, count, write=plain,
                          work=self.problem.work)

    def moved(self, direct: Any = ()):
        """The same motion, read with nodes of the time on further channels."""
        return self.alone.under(self.forcing(direct)) if direct else self.alone

    def instants(self, signals: "Sequence[Any]", points: int) -> "np.ndarray":
        """With those of fronts, each twice."""
        import numpy as np

        from vibcli.results.wave_signals import leaps

        found = sorted({t for signal in signals for t, *_ in leaps(signal, self.known)})[:points]
        return np.sort(np.concatenate([super().instants(signals, points), found, found]))

    def lasting(self):
        from vibcli.analyses.transient.duration import duration

        return duration(self.problem.modal.modes.shown(), None, 0.0, [])

    def _part(self, parts, name, primes, part):
        from vibcli.mechanics.inputs_outputs.place_signals import place_output

        found = place_output(self.configuration, name + "'" * primes) if isinstance(name, str) else None
        if found is None:
            return super()._part(parts, name, primes, part)
        constant = 0.0 if primes else self._at_rest(name)
        length = float(self.placed[found.piece].piece.length)
        point = FieldPoint(found.piece, float(found.share) * length, found.order, found.primes)
        output = LinearOutput(constant, places={point: float(found.factor)})
        return self._named(parts, f"signal {name}" + "'" * primes, (output, None))

    def _at_rest(self, name):
        """A signal in equilibrium."""
        from vibcli.mechanics.inputs_outputs.displacements import resting
        from vibcli.symbolic.evaluation import Floats, evaluate

        node = resting(self.problem.scene.resting, name)
        return evaluate([node], Floats, self.configuration.at_rest)[0]

    def _linear(self, constant, terms, source=()):
        from vibcli.results.wave_signals import WaveSignal

        return WaveSignal(*self._driven(constant, terms))

    def _composed(self, node, parts, source=()):
        from vibcli.results.wave_signals import ComposedOfWaves

        if self._closing(node) is not None:
            raise PhysicsError("signals of loops that close are not found where waves travel", "ask for coordinates")
        signals = {symbol.name: self._one(part) for symbol, part in parts.items()}
        return ComposedOfWaves(node, signals, self.values, self.problem.scene.time, None, self.problem.work)

    def state_signal(self, node: "Node"):
        """Energies of members are spread along them: they are not found."""
        raise PhysicsError("energies of scenes with members that vibrate are not found in time",
                           "ask for displacements, forces and stresses")
