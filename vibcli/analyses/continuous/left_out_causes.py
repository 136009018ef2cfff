"""Why no bound is known of what modes left out add: what a motion starts with, what moves its driven ends and what else
loads it, each taken alone."""

from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from collections.abc import Callable, Iterable

    from vibcli.analyses.continuous.left_out_energy import LeftOutEnergy
    from vibcli.analyses.continuous.left_out_motions import LeftOutMotions
    from vibcli.analyses.excitation.linear_output import LinearOutput

AT_ONCE = "as a load, or a rate of it, sets in or lets go at once where nothing has mass"
TOO_SUDDEN = "as a load strikes, or sets in, too suddenly for a force or a rate like this"
PACE = "as a load changes as fast as the modes that are counted"
NO_POLYNOMIAL = "as loads along a chain or mast are no polynomials of the place"
MOVED = "as a driven end, or a rate of its displacement, jumps"
IN_FIELD = "as it is a force, or a rate, after a start in a field"
UNFIT = f"{IN_FIELD} that is not smooth, or does not fit all ends and joints"
TOGETHER = "as a start and loads together leave energies whose sum is not known"
DRIVES = "as not all dampers are sure to take energy out"
RETARDED = "as `damping:` resists the rate at which members bend or stretch"
GROWS = "as it grows"
TORN = "as it starts in a field that is torn or bent sharply"
CLOSE = "as modes, or a start divided in so many of them, are not told apart well enough"


def flaw_of(damps: bool, retarded: bool, grows: bool, torn: bool, apart: bool) -> str:
    """Why energies tell nothing at all; "" where they do. apart: are modes told apart?"""
    found = (not damps, DRIVES), (retarded, RETARDED), (grows, GROWS), (torn, TORN), (not apart, CLOSE)
    return next((reason for holds, reason in found if holds), "")


def causes(motions: "LeftOutMotions", output: "LinearOutput") -> str:
    """All that leaves an output without a bound when nothing else acts, in words."""
    energy = motions.energy
    if energy.flaw:
        return energy.flaw
    found = [_of_start(output, energy)] if _stands(motions, output, energy.in_fields, _nothing) else []
    driven = energy.loads.driven
    for chosen in (driven.__contains__, lambda channel: channel not in driven):
        if _stands(motions, output, False, chosen):
            found += _of_loads(motions.only(False, chosen), output)
    return ", and ".join(dict.fromkeys(found)) or TOGETHER


def _nothing(_: int) -> bool:
    return False


def _stands(motions: "LeftOutMotions", output: "LinearOutput", start: bool,
            chosen: "Callable[[int], bool]") -> bool:
    """Does a start in fields, or do loads on these channels, alone leave it without a bound?"""
    return not motions.only(start, chosen).bounds(output, 0.0)


def _of_start(output: "LinearOutput", energy: "LeftOutEnergy") -> str:
    return UNFIT if max(one.level for one in energy.readings(output, 0)) == 1 else IN_FIELD


def _of_loads(motions: "LeftOutMotions", output: "LinearOutput") -> "Iterable[str]":
    """Of a motion without a start."""
    energy, beyond = motions.energy, motions.beyond(output)
    taken = [key for key in beyond if energy.loads.takes(key[0])]
    if len(taken) < len(beyond):
        yield NO_POLYNOMIAL
    if any(power >= 0 for *_, power in taken):
        yield PACE
    sudden = [channel for channel, _, power in taken if power < 0]
    if motions.jumps(output) or any(channel in energy.loads.driven for channel in sudden):
        yield MOVED
    still = [channel for channel in sudden if channel not in energy.loads.driven]
    massive = [bool(energy.loads.massive([channel])[0, 0]) for channel in still]
    if any(massive):
        yield TOO_SUDDEN
    if not all(massive):
        yield AT_ONCE
