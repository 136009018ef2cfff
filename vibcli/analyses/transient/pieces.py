"""A linear motion segment by segment: its state at their starts, and what drives it from there on."""

import math
from collections.abc import Sequence
from functools import cached_property
from typing import TYPE_CHECKING, Any

import numpy as np

from vibcli.analyses.transient.exponential_sum import ExponentialSum
from vibcli.analyses.transient.forced import Drive, drives, ends, marched
from vibcli.analyses.transient.forcing_arrays import Timeline, timeline_of
from vibcli.base.errors import PhysicsError

if TYPE_CHECKING:
    from vibcli.analyses.excitation.linear_output import LinearOutput
    from vibcli.analyses.transient.linear_response import LinearMotion
    from vibcli.analyses.transient.motion_errors import MotionErrors

MOST, STRETCHES = 20_000, 1000      # steps, each so many stretches of time of one exponential


class Pieces:
    """states: of each block c at the starts of the segments of the timeline; until: up to when these are all. driven:
    what drives the blocks, where it is known already. recorded: are the segments so many that some are looked at?"""

    recorded = False

    def __init__(self, motion: "LinearMotion", timeline: Timeline, states: Sequence[np.ndarray], until: float,
                 driven: list[list[Drive]] | None = None) -> None:
        self.motion, self.timeline, self.states, self.until, self._driven = motion, timeline, states, until, driven

    @cached_property
    def drives(self) -> list[list[Drive]]:
        """What drives each block."""
        return _driven(self.motion, self.timeline) if self._driven is None else self._driven

    @cached_property
    def errors(self) -> "MotionErrors":
        """Bounds of what rounding has done to it."""
        from vibcli.analyses.transient.motion_errors import MotionErrors

        return MotionErrors(self)

    def terms(self, output: "LinearOutput", order: int) -> Any:
        """What the order-th derivative of the output is the sum of."""
        return ExponentialSum(self, output, order)

    def on(self, output: "LinearOutput", segment: int, split: bool = True) -> list[tuple[tuple[complex, ...], complex]]:
        """(nodes, factor) of all that an output is the sum of on one segment, −1 the last: Re Σ factor · E[nodes]."""
        return ExponentialSum(self, output, 0, split).on(segment % len(self.timeline.starts))


def followed(motion: "LinearMotion", until: float) -> Pieces:
    """The Pieces of a motion up to a time."""
    forcing = motion.forcing
    timeline = timeline_of(forcing.channels, forcing.segments(math.nextafter(until, math.inf), motion.work))
    require_held(motion, timeline)
    driven = _driven(motion, timeline)
    return Pieces(motion, timeline, _states(motion, timeline, driven), until, driven)


def _driven(motion: "LinearMotion", timeline: Timeline) -> list[list[Drive]]:
    return drives(motion.blocks, timeline, len(motion.M) == 1)


def _states(motion: "LinearMotion", timeline: Timeline, driven: Sequence[list[Drive]]) -> list[np.ndarray]:
    """c of each block at the starts of the segments: (segments, p)."""
    jumps, found = timeline.impulses[:, :len(motion.M)], []
    struck = np.flatnonzero(jumps.any(axis=1))
    marching = motion.work.task("the motion from one jump or bend of its loads to the next", MOST)
    with marching as task, np.errstate(over="ignore", invalid="ignore"):
        for number, (block, its) in enumerate(zip(motion.blocks, driven, strict=True)):
            task.step(number / len(motion.blocks), len(timeline.starts) * len(block.B)**2 / STRETCHES)
            step, added = ends(block, its, timeline)
            added[struck] += jumps[struck] @ block.W.T
            found.append(marched(step, added, block.P @ motion.q0 + block.R @ motion.v0))
    return found


def require_held(motion: "LinearMotion", timeline: Timeline) -> None:
    """Refuses blows on what neither inertia nor a damper holds back."""
    if motion.system is not None and (timeline.impulses[:, :len(motion.M)] @ motion.system.follow).any():
        raise PhysicsError("a blow falls on what neither inertia nor a damper holds back: it would be displaced "
                           "without bound", hint="give it an inertia or a damper, or let the blow last")
