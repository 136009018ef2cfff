"""Loads that begin, end and strike: the motion from rest as the sum of what each piece brings about.

    unit impulse    e^{−δτ} sin ω_dτ / (M ω_d)
    unit step       (1 − e^{−δτ} (cos ω_dτ + δ sin ω_dτ / ω_d)) / K
    unit ramp       (τ − 2δ/ω² + e^{−δτ} (2δ cos ω_dτ / ω² + (δ² − ω_d²) sin ω_dτ / (ω² ω_d))) / K
    sin Ωτ          (R sin Ωτ − S cos Ωτ + e^{−δτ} (S cos ω_dτ + (δS − ΩR) sin ω_dτ / ω_d)) / (R² + S²)
    cos Ωτ          (R cos Ωτ + S sin Ωτ − e^{−δτ} (R cos ω_dτ + (δR + ΩS) sin ω_dτ / ω_d)) / (R² + S²)

    sin ωτ          (sin ωτ − ωτ cos ωτ)/(2 K),   cos ωτ   ωτ sin ωτ/(2 K)   where nothing damps

with R = K − MΩ², S = CΩ and τ > 0 the time since it began (Thomson & Dahleh 1998, chapter 4); of any other load the
integral of the impulses that it consists of.
"""

from collections.abc import Sequence
from typing import TYPE_CHECKING, Any

from vibcli.base.named_tuple import NamedTuple
from vibcli.report.blocks import Factor, Name, Words
from vibcli.report.steps.degree import Degree
from vibcli.report.steps.extremes import Swing, tell_extremes
from vibcli.report.steps.free_arcs import rest_behind, tell_arcs
from vibcli.report.steps.matrix_units import unit_of_entry
from vibcli.report.steps.motion_by_pieces import MotionByPieces, ToldPiece
from vibcli.report.steps.resonance import ROUNDED
from vibcli.report.steps.unit_responses import UnitResponses
from vibcli.symbolic.derivatives import gradient, substitute
from vibcli.symbolic.normal_form import TooLong, expanded, is_zero, textbook
from vibcli.symbolic.rationals import ONE

if TYPE_CHECKING:
    from fractions import Fraction

    from vibcli.scene.scene import Scene
    from vibcli.symbolic.node import Monomial, Node

KINDS = {"impulse": "a unit impulse", "step": "a unit step", "ramp": "a ramp of unit slope", "sin": "sin Ωτ, begun",
         "cos": "cos Ωτ, begun"}
WAVES = "sin", "cos"


class LoadPiece(NamedTuple):
    """factor·kind(t − begins), of a wave factor·sin(Ω·(t − begins)) from then on, Ω being its `rate`."""

    kind: str
    factor: Any
    begins: Any
    rate: Any = None


def pieces_of(scene: "Scene", load: "Node") -> list[LoadPiece] | None:
    """The pieces of a load; None where it is not made of these alone."""
    try:
        terms = expanded(load)
    except (TooLong, ZeroDivisionError):
        return None
    found: dict[Any, Any] = {}
    for monomial, value in terms.items():
        for piece in _pieces(scene, monomial, value) or [None]:
            if piece is None:
                return None
            key = piece.kind, piece.begins, piece.rate
            found[key] = found.get(key, scene.table.zero) + piece.factor
    settled = [LoadPiece(kind, textbook(factor), begins, rate) for (kind, begins, rate), factor in found.items()]
    alike = len({piece.rate for piece in settled if piece.rate is not None}) <= 1
    return [piece for piece in settled if not piece.factor.is_zero] if alike else None


def _pieces(scene: "Scene", monomial: "Monomial", value: "Fraction | int") -> list[LoadPiece] | None:
    """Those of factor·tⁿ·kind(t − t₁), n being 1 of a step at most; None where it is none."""
    table, time = scene.table, scene.time
    moving = [(atom, e) for atom, e in monomial if atom.mask & time.mask]
    factor = table.product((table.number(value), ONE), *(pair for pair in monomial if pair not in moving))
    calls = [atom for atom, e in moving if atom.op == "call" and atom.name in KINDS and (
        atom.name not in WAVES) and e == 1]
    others = [(atom, e) for atom, e in moving if atom not in calls]
    wave = others[0][0] if len(others) == 1 and others[0][1] == 1 and others[0][0].op == "call" else None
    if len(calls) != 1 or factor.mask or not (wave or others in ([], [(time, ONE)])):
        return None
    call, = calls
    slope = gradient(call.args[0]).get(time)
    if slope is not table.one:
        return None
    begins = textbook(-substitute([call.args[0]], {time: table.zero})[0])
    if wave is not None:
        return _begun(wave, factor, begins, time) if call.name == "step" else None
    if not others:
        return [LoadPiece(call.name, factor, begins)]
    return [LoadPiece("ramp", factor, begins), LoadPiece("step", factor * begins, begins)] if call.name == "step" else (
        [LoadPiece("impulse", factor * begins, begins)] if call.name == "impulse" else None)


def tell_impulses(degree: Degree) -> None:
    """The motion from rest under any load, as the sum of the impulses that it consists of; of under-damped ones."""
    rest = degree.about.value(degree.K / degree.M - (degree.C / degree.M / 2) ** 2)
    if rest is None or rest <= 0 or not _from_rest(degree):
        return
    t, name = degree.problem.scene.time, Name(degree.name)
    tau = degree.about.letter(degree.sheet.letter("tau"))
    weight = substitute([_unit(degree, "impulse")], {tau: t - tau})[0]
    Q = degree.sheet.letter("Q")
    head = [Words("from rest, with the right side "), Name(Q), Words(", the integral from "), tau, " = 0",
            Words(" to "), t, Words(" of its impulses:  ")]
    degree.sheet.write(*head, name, " = ", Words("∫ "), Name(Q), "(", tau, ")·", Factor(weight), "·d", tau,
                       settles="convolution", uses=degree.found.lines)


def _from_rest(degree: Degree) -> bool:
    """Does the motion start at rest, as the file says or leaves out?"""
    from vibcli.mechanics.initial_state import start_in_letters

    return all(node.is_zero for node in start_in_letters(degree.problem.symbolic) or ())


def _begun(wave: "Node", factor: "Node", begins: "Node", time: "Node") -> list[LoadPiece] | None:
    """factor·sin(Ωt + φ) or the cosine from an instant on, as waves that begin with τ = 0; None of other functions."""
    table, Omega = wave.table, gradient(wave.args[0]).get(time)
    if wave.name not in WAVES or Omega is None or Omega.mask:
        return None
    if Omega.op == "product" and Omega.coefficient < 0:
        Omega, factor = -Omega, -factor if wave.name == "sin" else factor
        argument = -wave.args[0]
    else:
        argument = wave.args[0]
    ahead = textbook(substitute([argument], {time: begins})[0])
    sine, cosine = table.call("sin", ahead), table.call("cos", ahead)
    parts = {"sin": (cosine, sine), "cos": (-sine, cosine)}[wave.name]
    return [LoadPiece(kind, factor * part, begins, Omega) for kind, part in zip(WAVES, parts, strict=True)]


def tell_pieces(degree: Degree, pieces: Sequence[LoadPiece]) -> None:
    """What a unit of each kind brings about from rest, and the motion as their sum; of under-damped ones."""
    rest = degree.about.value(degree.K / degree.M - (degree.C / degree.M / 2) ** 2)
    if (rest is not None and rest <= 0) or not _from_rest(degree):
        return
    sheet, letters = degree.sheet, {}
    Omega, lines = _resistances(degree, pieces)
    units = {kind: _unit(degree, kind, Omega) for kind in dict.fromkeys(piece.kind for piece in pieces)}
    for kind, unit in units.items():
        letters[kind] = sheet.letter(degree.name, kind)
        lightly = ", under-damped," if rest is None and not degree.C.is_zero else ""
        of = KINDS[kind].replace("Ω", "ω") if Omega is None else KINDS[kind]
        head = Words(f"{of} at τ = 0 brings about{lightly} from rest  ")
        lines.append(sheet.write(head, Name(letters[kind]), "(τ) = ", unit, settles=letters[kind],
                                 uses=degree.found.lines))
    told = [ToldPiece(piece.factor, _by_name(degree, piece.begins), units[piece.kind], letters[piece.kind], piece.kind,
                      piece.rate) for piece in pieces]
    settles = None if degree.C.is_zero else rest_behind(degree, told[-1].begins, told)
    motion = MotionByPieces(told, degree.about.letter(sheet.letter("tau")), sheet.last + 1, settles)
    sheet.write(Words("so by superposition  "), Name(degree.name), " = ", *motion.told(
        told, degree.problem.scene.time), Words("   (each from when its argument is positive)"),
        settles="forced motion", uses=lines)
    sheet.by_pieces[degree.name] = motion
    if [piece.kind for piece in pieces] == ["step"]:
        (F, begins, *_), rest = told[0], degree.about.place[degree.about.scene.q[0]]
        follows = textbook(F / degree.K)
        tell_extremes(degree, Swing(rest + follows, -follows, None, begins, motion.line))
    else:
        tell_arcs(degree, motion)


def _by_name(degree: Degree, instant: "Node") -> "Node":
    """An instant by the letter that the file has for it."""
    parameters = degree.problem.scene.parameters
    return next((parameters.nodes[name] for name, node in parameters.in_letters.items() if is_zero(node - instant)),
                instant)


def _resistances(degree: Degree, pieces: Sequence[LoadPiece]) -> "tuple[Node | None, list[int]]":
    """(Ω of waves, the numbers of the lines of Ω, R and S), (None, []) of other pieces and at resonance that nothing
    damps."""
    rate = next((piece.rate for piece in pieces if piece.rate is not None), None)
    if rate is None:
        return None, []
    resists = degree.K - degree.M * rate ** 2
    if _resonates(degree, resists):
        return None, []
    Omega, lines = rate, []
    if rate.op != "symbol":
        Omega = degree.about.letter(degree.sheet.letter("Omega"))
        lines = [degree.settled([Omega], rate, "rad/s", "Omega of the load", degree.found.lines)]
        degree.about.know(Omega, degree.about.value(rate))
    unit = unit_of_entry(degree.problem, 0, 0)
    nodes = {"R": degree.K - degree.M * Omega ** 2, "S": degree.C * Omega}
    for letter, node in nodes.items():
        if not node.is_zero:
            symbol = degree.about.letter(degree.sheet.letter(letter))
            lines.append(degree.settled([symbol], node, unit, letter, [*lines, *degree.found.lines],
                                        joined=letter == "S"))
    return Omega, lines


def _resonates(degree: Degree, resists: "Node") -> bool:
    return degree.C.is_zero and (is_zero(resists) or degree.about.cancel([degree.K, resists - degree.K], ROUNDED))


def _unit(degree: Degree, kind: str, Omega: "Node | None" = None) -> "Node":
    """The response to a unit of a kind as a function of τ; Ω is None of a wave at the natural frequency."""
    damped = not degree.C.is_zero
    tau, R, S = (degree.about.letter(degree.sheet.letter(name)) for name in ("tau", "R", "S"))
    unit = UnitResponses(degree.M, degree.K, degree.omega, degree.delta, degree.omega_d, tau, damped)
    if kind not in WAVES:
        return unit.of(kind)
    return unit.to_own_wave(kind) if Omega is None else unit.to_wave(kind, Omega, R, S if damped else tau.table.zero)
