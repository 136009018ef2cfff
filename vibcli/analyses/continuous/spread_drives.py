"""Loads along members as inputs: f(x) times what varies in time, on every piece between two places of a member."""

from typing import TYPE_CHECKING, Any

import numpy as np

from vibcli.analyses.excitation.load_forms import load_form
from vibcli.base.errors import PhysicsError
from vibcli.base.named_tuple import NamedTuple
from vibcli.mechanics.smooth_forms import smooth_form
from vibcli.numerics.pieces.loads import LoadForm, end_loads, end_loads_slope, loaded_fields
from vibcli.numerics.pieces.retardation import reaction_rate, retarded_reaction
from vibcli.symbolic.evaluation import evaluate
from vibcli.symbolic.smooth_panels import NotSmooth

if TYPE_CHECKING:
    from collections.abc import Mapping, Sequence

    from vibcli.mechanics.configuration import Configuration
    from vibcli.mechanics.factored_system import PlacedPiece
    from vibcli.scene.spread_forces import SpreadForce


POINTS = 33     # at which the size of a load is looked at


class SpreadDrive(NamedTuple):
    """f(x), a LoadForm over the places of a member, from `start` to `end`."""

    member: str
    start: Any
    end: Any
    form: LoadForm

    def on(self, placed: "PlacedPiece") -> LoadForm | None:
        """f on a piece, counted from its left end; None where there is none."""
        middle = placed.start + placed.piece.length / 2
        if placed.owner != self.member or not self.start < middle < self.end:
            return None
        return self.form.on(placed.start, placed.start + placed.piece.length)

    def end_loads(self, placed: "PlacedPiece", s: Any, steep: bool = False) -> Any:
        """What it puts on the ends of a piece at s, (…, order), or how that changes with s; None of other pieces."""
        form, piece = self.on(placed), placed.piece
        if form is None:
            return None
        s = np.asarray(s)
        kappa = retarded_reaction(piece, s, placed.retardation)
        if not steep:
            return end_loads(piece, kappa, form)
        return end_loads_slope(piece, kappa, form) * reaction_rate(piece, s, placed.retardation)[..., None]

    def put(self, pieces: "Sequence[PlacedPiece]", s: np.ndarray, n: int) -> np.ndarray:
        """What it puts on n coordinates by the ends of pieces, (number of s, n)."""
        found = np.zeros((len(s), n), complex)
        for one in pieces:
            ends = self.end_loads(one, s)
            for a, row in enumerate(one.rows if ends is not None else ()):
                for i, v in row.items():
                    found[:, i] += v * ends[:, a]
        return found

    def size(self, placed: "PlacedPiece") -> list[float]:
        """What ∫ |f| H dx may be on the ends of a piece: sums that cancel round by as much."""
        length, form = float(placed.piece.length), self.on(placed)
        x = length * np.linspace(0.0, 1.0, POINTS)
        most = 0.0 if form is None else sum(float(np.abs(one.size(x)).max()) for one in form.stretches)
        return [most * length, most * length**2][:placed.piece.order // 2] * 2

    def between(self, placed: "PlacedPiece", s: np.ndarray, x: float, along: int) -> Any:
        """What it bends a piece by while its ends are held: u at x, or a derivative of it, (N,)."""
        form = self.on(placed)
        return 0.0 if form is None else loaded_fields(placed.piece, placed.piece.reaction(s), form, x)[..., along]


def spread_drive(force: "SpreadForce", values: "Mapping[str, Any]", arithmetic: Any,
                 precise: bool = False) -> SpreadDrive:
    """The SpreadDrive of a SpreadForce; `values`: {name: number} of all symbols but the place."""
    from vibcli.analyses.excitation.decompose import forcing_of

    start, end = evaluate([force.start, force.end], arithmetic, values)
    try:
        given = forcing_of({0: force.along}, force.x, values, 1, precise)
    except PhysicsError:
        given = None
    if given is not None and not any(segment.impulses for segment in given.segments(end)):
        return SpreadDrive(force.member, start, end, load_form(given, 0, end))
    try:
        form = smooth_form(force.along, force.x, (force.start, force.end), values, arithmetic)
    except NotSmooth as error:
        raise PhysicsError(f"'{force.owner}' along '{force.member}' {error.message}", error.hint) from None
    return SpreadDrive(force.member, start, end, form)


def spread_inputs(configuration: "Configuration", weights: "Mapping[int, Any]") -> dict[int, SpreadDrive]:
    """{coordinate of an input: its SpreadDrive} of those with a weight, at the precision of the configuration."""
    from vibcli.symbolic.evaluation import Floats

    opened = configuration.with_inputs
    scene, arithmetic = opened.scene, opened.arithmetic
    inputs = {force.weight: force for force in scene.spread_forces if force.weight in scene.inputs}
    return {j: spread_drive(inputs[scene.q[j]], opened.values, arithmetic, arithmetic is not Floats)
            for j, weight in weights.items() if weight and scene.q[j] in inputs}
