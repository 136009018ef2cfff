"""Loads that begin, end and strike: the motion from rest as the sum of what each piece brings about.

    unit impulse    e^{−δτ} sin ω_dτ / (M ω_d)
    unit step       (1 − e^{−δτ} (cos ω_dτ + δ sin ω_dτ / ω_d)) / K
    unit ramp       (τ − 2δ/ω² + e^{−δτ} (2δ cos ω_dτ / ω² + (δ² − ω_d²) sin ω_dτ / (ω² ω_d))) / K

with τ > 0 the time since it began (Thomson & Dahleh 1998, chapter 4).
"""

from collections.abc import Sequence
from typing import TYPE_CHECKING, Any, NamedTuple

from vibcli.report.blocks import Factor, Name, Words
from vibcli.report.steps.degree import Degree
from vibcli.symbolic.derivatives import gradient, substitute
from vibcli.symbolic.normal_form import TooLong, expanded, textbook
from vibcli.symbolic.rationals import ONE

if TYPE_CHECKING:
    from vibcli.scene.scene import Scene
    from vibcli.symbolic.node import Node

KINDS = {"impulse": "a unit impulse", "step": "a unit step", "ramp": "a ramp of unit slope"}


class LoadPiece(NamedTuple):
    """factor·kind(t − begins)."""

    kind: str
    factor: Any
    begins: Any


def pieces_of(scene: "Scene", load: "Node") -> list[LoadPiece] | None:
    """The pieces of a load; None where it is not made of these alone."""
    try:
        terms = expanded(load)
    except (TooLong, ZeroDivisionError):
        return None
    found: dict = {}
    for monomial, value in terms.items():
        for piece in _pieces(scene, monomial, value) or [None]:
            if piece is None:
                return None
            key = piece.kind, piece.begins
            found[key] = found.get(key, scene.table.zero) + piece.factor
    settled = [LoadPiece(kind, textbook(factor), begins) for (kind, begins), factor in found.items()]
    return [piece for piece in settled if not piece.factor.is_zero]


def _pieces(scene, monomial, value):
    """Those of factor·tⁿ·kind(t − t₁), n being 1 of a step at most; None where it is none."""
    table, time = scene.table, scene.time
    moving = [(atom, e) for atom, e in monomial if atom.mask & time.mask]
    factor = table.product((table.number(value), ONE), *(pair for pair in monomial if pair not in moving))
    calls = [atom for atom, e in moving if atom.op == "call" and atom.name in KINDS and e == 1]
    others = [(atom, e) for atom, e in moving if atom not in calls]
    if len(calls) != 1 or factor.mask or others not in ([], [(time, ONE)]):
        return None
    call, = calls
    slope = gradient(call.args[0]).get(time)
    if slope is not table.one:
        return None
    begins = textbook(-substitute([call.args[0]], {time: table.zero})[0])
    if not others:
        return [LoadPiece(call.name, factor, begins)]
    return [LoadPiece("ramp", factor, begins), LoadPiece("step", factor * begins, begins)] if call.name == "step" else (
        [LoadPiece("impulse", factor * begins, begins)] if call.name == "impulse" else None)


def tell_pieces(degree: Degree, pieces: Sequence[LoadPiece]) -> None:
    """What a unit of each kind brings about from rest, and the motion as their sum; of under-damped ones."""
    from vibcli.mechanics.initial_state import start_in_letters

    rest = degree.about.value(degree.K / degree.M - (degree.C / degree.M / 2) ** 2)
    if (rest is not None and rest <= 0) or start_in_letters(degree.problem.symbolic) is not None:
        return
    sheet, lines, letters = degree.sheet, [], {}
    for kind in dict.fromkeys(piece.kind for piece in pieces):
        letters[kind] = sheet.letter(degree.name, kind)
        lightly = ", under-damped," if rest is None and not degree.C.is_zero else ""
        head = Words(f"{KINDS[kind]} at τ = 0 brings about{lightly} from rest  ")
        lines.append(sheet.write(head, Name(letters[kind]), "(τ) = ", _unit(degree, kind), settles=letters[kind],
                                 uses=degree.found.lines))
    told: list[Any] = []
    for piece in pieces:
        negative = piece.factor.op != "sum" and piece.factor.coefficient < 0
        size = -piece.factor if negative else piece.factor
        sign = " − " if negative and told else "−" if negative else " + " if told else ""
        factor = [] if size is size.table.one else [Factor(size), "·"]
        told += [sign, *factor, Name(letters[piece.kind]), "(", degree.problem.scene.time - piece.begins, ")"]
    sheet.write(Words("so by superposition  "), Name(degree.name), " = ", *[part for part in told if part != ""],
                Words("   (each from when its argument is positive)"), settles="forced motion", uses=lines)


def _unit(degree, kind):
    """The response to a unit of a kind as a function of τ."""
    table = degree.about.table
    tau, M, K = degree.about.letter(degree.sheet.letter("tau")), degree.M, degree.K
    damped = not degree.C.is_zero
    rate, delta = (degree.omega_d, degree.delta) if damped else (degree.omega, table.zero)
    sine, cosine = table.call("sin", rate * tau), table.call("cos", rate * tau)
    decay = table.call("exp", -(delta * tau)) if damped else table.one
    if kind == "impulse":
        return decay * sine / (M * rate)
    if kind == "step":
        return (1 - decay * (cosine + delta * sine / rate)) / K
    square = degree.omega ** 2
    return (tau - 2 * delta / square + decay * (2 * delta * cosine / square + (delta ** 2 - rate ** 2) * sine / (
        square * rate))) / K
