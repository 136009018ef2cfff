"""Small motions in as many digits as one likes, from the exact data: place, matrices, loads and outputs in mpmath.

It answers at the working precision at which it is made.
"""

from collections.abc import Mapping
from functools import cached_property
from typing import TYPE_CHECKING, Any

import mpmath

from vibcli.analyses.excitation.decompose import forcing_of
from vibcli.analyses.modal.modal_analysis import ModalAnalysis
from vibcli.analyses.transient.high_precision import precise_motion
from vibcli.mechanics.precise_configuration import PreciseConfiguration
from vibcli.mechanics.symbolic_system import SymbolicSystem
from vibcli.results.high_precision_response import given_start
from vibcli.results.precise_envelope import PreciseEnvelope
from vibcli.results.precise_signals import PreciseComposed, PreciseLinear
from vibcli.results.responses import SmallResponse

if TYPE_CHECKING:
    from collections.abc import Sequence

    from vibcli.analyses.excitation.forcing import Forcing
    from vibcli.analyses.transient.high_precision import PreciseMotion
    from vibcli.analyses.transient.textbook_form import Part
    from vibcli.results.problem import Problem
    from vibcli.results.responses import PartOfSignal, Terms
    from vibcli.symbolic.node import Node
    from vibcli.symbolic.syntax import NameRef, Sum, SyntaxTree


class PreciseResponse(SmallResponse):
    """Small oscillations about the equilibrium, its signals being PreciseLinear and PreciseComposed."""

    def __init__(self, problem: "Problem") -> None:
        super().__init__(problem)
        self.configuration: PreciseConfiguration = PreciseConfiguration(problem.configuration)
        self.arithmetic, self.values = self.configuration.arithmetic, self.configuration.values

    @cached_property
    def drive(self) -> "dict[int, Node]":
        """{i: Q(t)} of the small oscillations, the place of the equilibrium in it being as precise."""
        return SymbolicSystem(self.configuration, ModalAnalysis).excitation if self.problem.scene.timed else {}

    @cached_property
    def start(self) -> "tuple[dict[str, mpmath.mpf], dict[str, mpmath.mpf]]":
        """({coordinate: value}, {coordinate: velocity}) at t = 0."""
        held = self.configuration.preloaded
        rest = (held or self.configuration).equilibrium.values
        return given_start(self.problem, self.values, rest)

    @cached_property
    def matrices(self) -> tuple[list[list[mpmath.mpf]], list[list[mpmath.mpf]], list[list[mpmath.mpf]]]:
        """M, C + G, K as lists of rows."""
        n, (M, C, G, K) = len(self.problem.scene.coordinates), self.configuration.matrices
        damping = {pair: C.get(pair, 0) + G.get(pair, 0) for pair in {*C, *G}}
        M, C, K = ([[part.get((i, j), 0) for j in range(n)] for i in range(n)] for part in (M, damping, K))
        return M, C, K

    @cached_property
    def deviations(self) -> tuple[list[mpmath.mpf], list[mpmath.mpf]]:
        """(q, v) at t = 0, counted from the equilibrium."""
        (places, speeds), rest = self.start, self.configuration.equilibrium.values
        names = self.problem.scene.coordinates
        return [places[name] - rest[name] for name in names], [speeds[name] for name in names]

    def forcing(self, direct: Any = ()) -> "Forcing":
        """The Forcing of the coordinates; `direct`: nodes of the time on further channels."""
        n = len(self.problem.scene.coordinates)
        nodes = {**self.drive, **{n + number: node for number, node in enumerate(direct)}}
        return forcing_of(nodes, self.problem.scene.time, self.values, n + len(direct), precise=True,
                          work=self.problem.work)

    def moved(self, direct: Any = ()) -> "PreciseMotion":
        """The PreciseMotion under the excitation."""
        return precise_motion(*self.matrices, self.forcing(direct), *self.deviations)

    def envelope(self, signal: PreciseLinear, parts: "Sequence[Part]") -> PreciseEnvelope:
        """That of a signal whose vibrations are near Parts in floats."""
        return PreciseEnvelope(signal, parts)

    def _composed(self, node: "Node", parts: "Mapping[Node, PartOfSignal]",
                  source: "tuple[PreciseResponse, SyntaxTree] | None" = None) -> PreciseComposed:
        scene, closing = self.problem.scene, self._closing(node)
        signals = {symbol.name: self._one(part) for symbol, part in parts.items()}
        return PreciseComposed(node, signals, self.values, scene.time, self.arithmetic, closing)

    def _linear(self, constant: float, terms: "Terms",
                source: "tuple[NameRef | PreciseResponse | Sum, ...] | None" = None) -> PreciseLinear:
        return PreciseLinear(*self._driven(constant, terms))
