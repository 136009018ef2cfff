"""What sets modes in motion that start with a field u along members: in each, with L u = B u⁗ − ((N + n x) u′)′ + k u
and the forces F that its ends need, by Green's identity

    ω² ⟨φ, u⟩ = ∫ φ L u dx + φᵀ (K q + Σ Sᵀ F) − Σ e Q

e being how far ends of the field are from their nodes, Q the forces of the mode on its ends. L u is spread: of it
Σ (∫ φ L u dx)² = ∫ (L u)²/μ dx over all modes (Parseval). Where a field has a corner the piece is cut in two.
"""

from typing import TYPE_CHECKING, Any

import numpy as np

from vibcli.analyses.continuous.disturbances import derivatives
from vibcli.analyses.continuous.divided_pieces import divided_at
from vibcli.analyses.continuous.modal_start import of_load
from vibcli.analyses.continuous.uncounted_modes import POWERS, begins_at, left_of_squares
from vibcli.analyses.continuous.unit_responses import UnitLoads, overlaps
from vibcli.analyses.excitation.forcing import Forcing, Segment, Wave
from vibcli.analyses.excitation.load_forms import load_form
from vibcli.base.named_tuple import NamedTuple
from vibcli.numerics.pieces.graded import mirrored
from vibcli.numerics.pieces.graded_parts import is_slack
from vibcli.numerics.pieces.stiffness import stiffness_and_slope

if TYPE_CHECKING:
    from collections.abc import Mapping, Sequence

    from vibcli.analyses.continuous.mode_basis import ModeBasis
    from vibcli.analyses.continuous.spread_drives import SpreadDrive
    from vibcli.analyses.continuous.uncounted_modes import UncountedModes
    from vibcli.mechanics.factored_system import PlacedPiece
    from vibcli.numerics.pieces.piece import Piece

ROUNDING = 1e-12    # of a displacement or a force: what is none
NOISE = 2.0**-51    # of what a start is added from


class FieldStart(NamedTuple):
    """held: loads that would hold the field at rest, (channels,) of UncountedModes; spread: √(Σ b²/ω²ᵖ) of all else
    at each of POWERS; felt: ω² ⟨φ, u⟩ of the first modes, and what it is rounded from."""

    held: np.ndarray
    spread: np.ndarray
    felt: np.ndarray
    size: np.ndarray

    def of_modes(self, squares: np.ndarray, plain: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
        """⟨φ, u⟩ of modes with ω² = squares, and how much is lost by rounding: by this, or by the `plain` integrals
        where that is less."""
        lost = np.full(len(plain), NOISE * np.abs(plain).max(initial=0.0))
        with np.errstate(all="ignore"):
            own = np.where(squares > 0, NOISE * self.size / squares, np.inf)
            found = np.where(own < lost, self.felt / squares, plain)
        return np.where(np.abs(found) > np.minimum(own, lost), found, 0.0), np.minimum(own, lost)


class StartOfNodes(NamedTuple):
    """Displacements, or rates, of nodes and the sizes that they are rounded from, (nodes,) each."""

    q: np.ndarray
    size: np.ndarray

    def of(self, rows: "Sequence[Mapping[int, float]]") -> tuple[np.ndarray, np.ndarray]:
        """What rows over the nodes read, and the sizes of that."""
        return (np.array([sum(x * self.q[i] for i, x in row.items()) for row in rows]),
                np.array([sum(abs(x) * self.size[i] for i, x in row.items()) for row in rows]))

    def with_more(self, q: np.ndarray, size: np.ndarray) -> "StartOfNodes":
        """With more nodes behind these."""
        return StartOfNodes(np.append(self.q, q), np.append(self.size, size))


class _Stretch(NamedTuple):
    """A part of piece `number` from `start` of it on, u and what its ends need there with what they are rounded from,
    (order,) each; None of a part at rest."""

    number: int
    start: float
    placed: "PlacedPiece"
    u: np.ndarray | None
    u_size: np.ndarray | None
    forces: np.ndarray | None
    forces_size: np.ndarray | None


def start_of_field(uncounted: "UncountedModes", given: "Sequence[Forcing | None]", start: StartOfNodes, resting: bool,
                   let_go: "Sequence[SpreadDrive]" = ()) -> FieldStart:
    """Of fields u, Forcings over pieces, and of coordinates; where none is given a piece is at rest under its ends and
    loads that are let go if it is `resting`, else 0."""
    n, stretches, nodes = len(uncounted.K), [], start
    for number, forcing in enumerate(given):
        found, nodes = _stretches(uncounted.pieces[number], number, forcing, nodes)
        stretches += found
    held, added = np.zeros(len(uncounted.begins)), len(nodes.q) - n
    held[:n] = uncounted.K @ start.q
    forces, sizes = (np.pad(part, (0, added)) for part in (held[:n], np.abs(uncounted.K) @ start.size))
    ends = {}
    for k, one in enumerate(stretches):
        moved, moved_size = nodes.of(one.placed.rows)
        F, F_size = one.forces, one.forces_size
        if one.forces is None:
            d = stiffness_and_slope(one.placed.piece, np.float64(one.placed.piece.foundation))[0]
            F, F_size = (d @ moved, np.abs(d) @ moved_size) if resting else (0 * moved, 0 * moved)
            for put in (drive.end_loads(one.placed, 0.0) for drive in let_go if drive.on(one.placed) is not None):
                F, F_size = F - put, F_size + np.abs(put)
        for row, force, rounded in zip(one.placed.rows, F, F_size, strict=True):
            for i, x in row.items():
                forces[i] += x * force
                sizes[i] += abs(x) * rounded
        if one.u is not None or not resting:
            u, u_size = (0 * moved, 0 * moved) if one.u is None else (one.u, one.u_size)
            rounded = np.tile(np.maximum(*np.split(u_size + moved_size, 2)), 2)     # on the whole stretch
            apart = (np.abs(u - moved) > ROUNDING * rounded) & ~_loose(one.placed.piece)
            gaps = np.where(apart, u - moved, 0.0)
            ends |= {(k, end): gap for end, gap in enumerate(gaps.tolist()) if gap}
    forces = np.where(np.abs(forces) > ROUNDING * sizes, forces, 0.0)
    held[:n], forces[:n] = forces[:n], 0.0
    for j, drive in enumerate(uncounted.driven):
        for k, end in [at for at in ends if stretches[at[0]].number == drive.piece and at[1] == drive.end
                       and _outer(stretches, *at)]:
            held[n + j] = ends.pop((k, end))
    inputs, rounded = uncounted.inputs, np.append(sizes[:n], np.abs(held[n:]))
    at_corners, pointed = _pointed(uncounted, stretches, forces, ends)
    along, spread, norm = _spread(uncounted, given, let_go)
    return FieldStart(held, at_corners + along, inputs @ held + pointed + spread,
                      np.abs(inputs) @ rounded + np.abs(pointed) + norm)


def _loose(piece: "Piece") -> np.ndarray:
    """Which ends have no tension, so that nothing holds them to a node, (order,)."""
    if piece.order != 2 or not piece.gradient:
        return np.zeros(piece.order, bool)
    return np.array([is_slack(piece), is_slack(mirrored(piece))])


def _stretches(placed: "PlacedPiece", number: int, forcing: Forcing | None,
               nodes: StartOfNodes) -> tuple[list[_Stretch], StartOfNodes]:
    """The _Stretches of a piece, and the StartOfNodes with those at corners."""
    if forcing is None:
        return [_Stretch(number, 0.0, placed, None, None, None, None)], nodes
    found, segments, start = [], forcing.segments(np.inf), 0.0
    length, half = placed.piece.length, placed.piece.order // 2
    for segment, end in zip(segments, [*(one.start for one in segments[1:]), length], strict=True):
        if start < end < length:
            placed, rest = divided_at(placed, end - start, len(nodes.q))
            nodes = nodes.with_more(*(part[:half] for part in _along(segment, end - segment.start)))
        elif start < length:
            rest, end = placed, length
        else:
            break
        left, right = (_along(segment, x - segment.start) for x in (start, end))
        found.append(_Stretch(number, start, placed, *_at_ends(placed.piece, left, right)))
        placed, start = rest, end
    return found, nodes


def _along(segment: Segment, x: float) -> tuple[np.ndarray, np.ndarray]:
    """u … u‴ of a field, and the sizes that they are rounded from."""
    parts = [derivatives(wave, x, 4) for wave in segment.waves]
    found, sizes = (sum((part[side] for part in parts), np.zeros(4)) for side in range(2))
    return found, sizes


def _at_ends(piece: "Piece", left: tuple[np.ndarray, np.ndarray],
             right: tuple[np.ndarray, np.ndarray]) -> tuple[np.ndarray, np.ndarray, np.ndarray, np.ndarray]:
    """End values, their sizes, the forces that the ends need, and theirs."""
    half, found = piece.order // 2, []
    for side in range(2):
        found += [np.concatenate([left[side][:half], right[side][:half]]),
                  np.concatenate([_forces(piece, left[side], 0.0, -1.0, bool(side)),
                                  _forces(piece, right[side], piece.length, 1.0, bool(side))])]
    return found[0], found[2], found[1], found[3]


def _forces(piece: "Piece", u: np.ndarray, x: float, sign: float, as_size: bool) -> np.ndarray:
    """Of an end, from u … u‴; or what they are rounded from."""
    tension, back, sign = piece.tension + piece.gradient * x, 1.0 if as_size else -1.0, 1.0 if as_size else sign
    across = (abs(tension) if as_size else tension) * u[1]
    if piece.order == 2:
        return np.array([sign * across])
    return sign * np.array([across + back * piece.bending * u[3], piece.bending * u[2]])


def _outer(stretches: "Sequence[_Stretch]", k: int, end: float) -> bool:
    """Is an end of a _Stretch one of the whole piece?"""
    half = stretches[k].placed.piece.order // 2
    beside = k - 1 if end < half else k + 1
    return not 0 <= beside < len(stretches) or stretches[beside].number != stretches[k].number


def _pointed(uncounted: "UncountedModes", stretches: "Sequence[_Stretch]", forces: np.ndarray,
             ends: "Mapping[tuple[int, int], float]") -> tuple[np.ndarray, np.ndarray]:
    """√(Σ b²/ω²ᵖ) of forces on nodes at corners and of dislocations, at each of POWERS, and b of the first modes."""
    n, basis, begins, first = len(uncounted.K), uncounted.basis, 0.0, np.zeros(len(uncounted.basis.squares))
    if not forces.any() and not ends:
        return np.zeros(len(POWERS)), first
    loads = UnitLoads(forces[:, None], {at: np.array([gap]) for at, gap in ends.items()})
    for k, one in enumerate(stretches):
        piece = one.placed.piece
        half = piece.order // 2
        for end, row in enumerate(one.placed.rows):
            x, at = one.start + piece.length * (end >= half), end % half
            corner = [i for i in row if i >= n and end >= half and forces[i]]
            if corner:
                first += forces[corner[0]] * basis.field(one.number, x, at)
                begins = max(begins, begins_at(piece.order, at))
            if (k, end) in ends:
                first -= ends[k, end] * _force(basis, one, x, at, end >= half)
                begins = max(begins, begins_at(piece.order, piece.order - 1 - at))
    R = uncounted.left([one.placed for one in stretches], loads, first[:, None])
    return np.sqrt([uncounted.sums(R, p, begins)[0, 0] for p in POWERS]), first


def _force(basis: "ModeBasis", one: _Stretch, x: float, at: int, right: bool) -> Any:
    """What an end needs in each mode."""
    piece, sign = one.placed.piece, 1.0 if right else -1.0
    tension = piece.tension + (piece.gradient * piece.length if right else 0.0)
    if at:
        return sign * piece.bending * basis.field(one.number, x, 2)
    force = tension * basis.field(one.number, x, 1)
    return sign * (force - piece.bending * basis.field(one.number, x, 3) if piece.order == 4 else force)


def _spread(uncounted: "UncountedModes", given: "Sequence[Forcing | None]",
            let_go: "Sequence[Any]") -> tuple[np.ndarray, np.ndarray, float]:
    """√(Σ (∫ φ L u dx)²/ω²ᵖ), at each of POWERS, ∫ φ L u dx of the first modes, and the most that it can be."""
    total, known = 0.0, np.zeros(len(uncounted.basis.squares))
    for number, (placed, forcing) in enumerate(zip(uncounted.pieces, given, strict=True)):
        piece = placed.piece
        forms = [form for drive in let_go if (form := drive.on(placed)) is not None]
        if forcing is not None:
            segments = [Segment(one.start, tuple(_answered(piece, one))) for one in forcing.segments(np.inf)]
            forms = [load_form(Forcing(1, segments), 0, piece.length)]
        known += sum((of_load(uncounted.basis, number, form) for form in forms), 0 * known)
        total += float(overlaps(forms).sum()) / piece.inertia
    left = np.sqrt(left_of_squares(total, known @ known)) * uncounted.highest ** -np.array(POWERS)
    return left, known, np.sqrt(total)


def _answered(piece: "Piece", segment: Segment) -> list[Wave]:
    """Waves of L u."""
    u = _together(segment.waves)
    slope = _slope(u)
    bent = _slope(slope)
    found = [*_scaled(u, piece.foundation), *_scaled(bent, -piece.tension - piece.gradient * segment.start),
             *_scaled(slope, -piece.gradient), *_scaled(_slope(_slope(bent)), piece.bending)]
    return found + [wave._replace(power=wave.power + 1) for wave in _scaled(bent, -piece.gradient)]


def _together(waves: tuple[Wave, ...]) -> list[Wave]:
    """Those of the same form as one."""
    found: dict[Any, complex] = {}
    for _, coefficient, power, exponent in waves:
        found[power, exponent] = found.get((power, exponent), 0.0) + coefficient
    return [Wave(0, coefficient, *form) for form, coefficient in found.items() if coefficient]


def _slope(waves: "Sequence[Wave]") -> list[Wave]:
    found = [wave._replace(coefficient=wave.coefficient * wave.exponent) for wave in waves if wave.exponent]
    return found + [wave._replace(coefficient=wave.coefficient * wave.power, power=wave.power - 1)
                    for wave in waves if wave.power]


def _scaled(waves: "list[Wave]", factor: float) -> "list[Wave]":
    return [wave._replace(coefficient=wave.coefficient * factor) for wave in waves if factor]
