"""The phase plane of one degree of freedom that loses or gains energy: orbits that are integrated, so far apart that
each can be seen, and the manifolds of saddles from their eigenvectors (1, λ)."""

from collections.abc import Iterator, Sequence
from typing import TYPE_CHECKING

import numpy as np

from vibcli.analyses.nonlinear.equilibrium_kinds import BOTH, SADDLE, Around, StateEquilibrium, beside
from vibcli.analyses.nonlinear.integrated_orbits import PhaseFrame, followed
from vibcli.analyses.nonlinear.phase_portrait import INTO, ORBIT, OUT_OF, OWN, StatePath

if TYPE_CHECKING:
    from vibcli.analyses.nonlinear.state_field import StateField

FIRST, SLOW = 1e-6, 2e-3        # of the frame: how far from a saddle its manifolds start; where λ = 0
ALONG, ACROSS, EDGE = 7, 5, 9   # places from which orbits are tried: inside, and along each edge
INSET = 0.97
APART = 0.17                    # of half the frame: nearer to a line no other one starts
LONG, OWN_LONG = 8.0, 16.0      # frames, at most
DENSE = 8                       # of the points of a line one in so many is looked at


def of_motion(field: "StateField", equilibria: Sequence[tuple[StateEquilibrium, Around]],
              start: tuple[float, float] | None, frame: PhaseFrame) -> list[StatePath]:
    """Manifolds of saddles, the motion from a start, and other orbits."""
    ends = [(one.q, 0.0) for one, _ in equilibria if one.attracts]
    begun = [row for one, around in equilibria for row in _manifolds(field, one, around, frame)]
    if start is not None:
        begun.append((start, 1, OWN, OWN_LONG))
    found = _lines(field, begun, frame, ends)
    found += _others(field, found, frame, ends)
    return found


def _manifolds(field: "StateField", one: StateEquilibrium, around: Around,
               frame: PhaseFrame) -> Iterator[tuple[tuple[float, float], int, str, float]]:
    """[(start, sense, role, length)] of the manifolds of a saddle."""
    if not one.kind.endswith((SADDLE, BOTH)):
        return
    pairs = [one.eigenvalues] * 2 if one.eigenvalues is not None else beside(field, one.q, around)
    if one.eigenvalues is not None and not any(one.eigenvalues):
        return
    width, height = frame.size.ravel().tolist()
    for side, (low, high) in zip((-1, 1), pairs, strict=True):
        for value, sense, role in ((low.real, -1, INTO), (high.real, 1, OUT_OF)):
            if one.kind == BOTH and not value:
                continue
            step = (FIRST if value else SLOW) * side / max(1 / width, abs(value) / height)
            yield (one.q + step, value * step), sense, role, LONG


def _lines(field: "StateField", begun: Sequence[tuple[tuple[float, float], int, str, float]], frame: PhaseFrame,
           ends: Sequence[tuple[float, float]]) -> list[StatePath]:
    if not begun:
        return []
    starts = np.array([start for start, *_ in begun]).T
    found = followed(field, starts, np.array([sense for _, sense, *_ in begun]), frame, ends,
                     np.array([length for *_, length in begun]))
    return [StatePath(*points[:, ::sense], role) for points, (_, sense, role, _) in zip(found, begun, strict=True)
            if points.shape[1] > 1]


def _others(field: "StateField", drawn: Sequence[StatePath], frame: PhaseFrame,
            ends: Sequence[tuple[float, float]]) -> list[StatePath]:
    """Orbits from places that no line is near, one after the other."""
    places = _places(frame)
    n = places.shape[1]
    lines = followed(field, np.tile(places, 2), np.repeat([1, -1], n), frame, ends, np.full(2 * n, LONG))
    known = [np.stack((one.q, one.v))[:, ::DENSE] / frame.size for one in drawn]
    known += [np.array([[q], [v]]) / frame.size for q, v in ends]
    found = []
    for i in range(n):
        here = places[:, i:i + 1] / frame.size
        if any((((line - here) ** 2).sum(axis=0) < APART**2).any() for line in known):
            continue
        line = np.concatenate((lines[n + i][:, :0:-1], lines[i]), axis=1)
        if line.shape[1] > 2:
            found.append(StatePath(*line, ORBIT))
            known.append(line[:, ::DENSE] / frame.size)
    return found


def _places(frame: PhaseFrame) -> np.ndarray:
    """Where orbits are tried: along the edges, then inside."""
    edge = np.linspace(-INSET, INSET, EDGE)
    x, y = np.meshgrid(np.linspace(-0.8, 0.8, ALONG), np.linspace(-0.75, 0.75, ACROSS))
    rim = np.full(EDGE, INSET)
    shares = np.concatenate(([edge, rim], [edge, -rim], [-rim, edge], [rim, edge], [x.ravel(), y.ravel()]), axis=1)
    middle = 0.5 * np.array([[sum(frame.q)], [sum(frame.v)]])
    found: np.ndarray = middle + shares * frame.size
    return found
