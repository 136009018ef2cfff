"""Instants at which what drives a scene jumps, bends or strikes: windows end there, so that no pulse is stepped over.

A function of time that is a piecewise sum of polynomials, exponentials and sines has them exactly (analyses/forcing);
of any other argument the zeros are searched among SAMPLES places.
"""

from collections.abc import Mapping, Sequence
from typing import TYPE_CHECKING

import numpy as np

from vibcli.analyses.excitation.decompose import forcing_of
from vibcli.analyses.excitation.forcing import TooOften
from vibcli.base.errors import PhysicsError
from vibcli.numerics.root_finding import last_place
from vibcli.symbolic.discontinuous_functions import PULSES
from vibcli.symbolic.evaluation import evaluate
from vibcli.symbolic.expression_graph import reachable

if TYPE_CHECKING:
    from vibcli.base.work import Work
    from vibcli.scene.scene import Scene
    from vibcli.symbolic.node import Node

SAMPLES, ROUNDS = 20_001, 80
BENT = ("abs", "sign", "min", "max", *PULSES)
MOST = 200_000
CLOSE = 1e-14


class Breaks:
    """times: ascending, after the start and before the end; blows: {instant: {impulse node: its size}}."""

    __slots__ = ("blows", "times")

    def __init__(self, times: np.ndarray, blows: "Mapping[float, dict[Node, float]]") -> None:
        self.times, self.blows = times, blows

    def after(self, t: float, until: float) -> float:
        """The next break after t; `until` if there is none before it."""
        i = int(np.searchsorted(self.times, t, side="right"))
        return min(self.times[i], until) if i < len(self.times) else until


def breaks(scene: "Scene", nodes: "Sequence[Node]", floats: Mapping[str, float], until: float, work: "Work") -> Breaks:
    """The Breaks of expressions within 0 and `until`."""
    found, blows = {0.0}, {}
    for node in reachable(nodes):
        if node.mask == scene.time.mask and node.name in ("square", "sawtooth") and len(node.args) > 1:
            raise PhysicsError(f"what jumps as {node.name} strikes this scene again and again: the energies of this "
                               "motion are not defined at an instant at which a function of the time in it jumps",
                               "write what drives it without jumps, as abs(sin(w*t)) or 1 - cos(w*t)")
        if node.mask == scene.time.mask and (node.name in BENT or node.name in node.table.records):
            times = _exact(scene, node, floats, until, blows, work)
            found.update(_searched(scene, node, floats, until) if times is None else times)
            if len(found) > MOST * work.patience:
                raise PhysicsError(f"what drives this scene jumps or bends more than {MOST * work.patience} times until"
                                   f" t = {until:.6g} s", f"ask for a shorter time; --patience {10 * work.patience:.0f}"
                                   " allows ten times as many")
    times = sorted(time for time in found if 0 < time < until * (1 - CLOSE))
    kept = [time for time, before in zip(times, [0.0, *times], strict=False) if time - before > CLOSE * time]
    places = np.array([0.0, *kept])
    return Breaks(places[1:], {_nearest(places, time): sizes for time, sizes in sorted(blows.items())})


def _nearest(times: np.ndarray, time: float) -> float:
    i = int(np.searchsorted(times[1:], time))
    return float(min(times[i:i + 2], key=lambda other: abs(other - time)))


def _exact(scene: "Scene", node: "Node", floats: Mapping[str, float], until: float,
           blows: "dict[float, dict[Node, float]]", work: "Work") -> list[float] | None:
    """The breaks of one function of the time; None where they are not known in closed form."""
    try:
        segments = forcing_of({0: node}, scene.time, floats, work=work).segments(until, work)
    except TooOften:
        raise
    except PhysicsError:
        return None
    for segment in segments:
        for _, size in segment.impulses if _strikes(node) else ():
            blows.setdefault(segment.start, {})[node] = size
    return [segment.start for segment in segments]


def _strikes(node: "Node") -> bool:
    """Does it hold impulses by itself? Of records the rates do: the second one where their slope jumps."""
    return node.name == "impulse" or (node.name in node.table.records and len(node.args) > 1)


def _searched(scene: "Scene", node: "Node", floats: Mapping[str, float], until: float) -> list[float]:
    """Where the argument of a function changes its sign, or passes a multiple of π."""
    from vibcli.symbolic.array_arithmetic import Arrays

    if node.name == "impulse" or node.name in node.table.records:
        raise PhysicsError(f"when {node.name} acts is not known", "let its argument be t − t1")
    argument = node.args[0] - node.args[1] if node.name in ("min", "max") else node.args[0]

    def turns(times: np.ndarray) -> np.ndarray:
        values = evaluate([argument], Arrays, {**floats, scene.time.name: times})[0] * np.ones(len(times))
        found: np.ndarray = np.floor(values / np.pi) if node.name in ("square", "sawtooth") else values >= 0
        return found

    times = np.linspace(0.0, until, SAMPLES)
    values = turns(times)
    found = []
    for i in np.flatnonzero(values[1:] != values[:-1]):
        before = values[i]
        end = last_place(lambda t, before=before: turns(np.array([t]))[0] == before, times[i], times[i + 1], ROUNDS)[1]
        found.append(float(end))
    return found
