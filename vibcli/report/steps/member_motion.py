"""The motion of members from their start and under loads, mode by mode (Rao 2007, chapters 8, 9 and 11):

    u = Σ X_k(x) p_k(t),   p̈_k + 2δ_k ṗ_k + ω_k² p_k = Q_k(t)/m_k,   m_k = ∫ μ X_k² dx + …,
    p_k(0) = ∫ μ X_k u(x, 0) dx/m_k,   Q_k = Σ X_k F + ∫ X_k f dx;

from rest p_k = ∫₀ᵗ Q_k(τ) e^{−δ(t − τ)} sin ω_d(t − τ) dτ/(m_k ω_d)."""

import re
from collections.abc import Mapping
from math import atan2, hypot, isfinite, sqrt
from typing import TYPE_CHECKING, Any

from vibcli.analyses.closed_form.member_shapes import ALONG, shape
from vibcli.analyses.closed_form.steady_state import waves_of_all
from vibcli.base.errors import NotInLetters, PhysicsError
from vibcli.base.named_tuple import NamedTuple
from vibcli.notation.names import GREEK, NAMES, lowered
from vibcli.notation.plain import plain
from vibcli.report.blocks import Name, Words
from vibcli.report.own_letters import own_letters
from vibcli.report.sections.orthogonality import orthogonality
from vibcli.report.sections.shapes_in_numbers import shape_in_numbers
from vibcli.report.steps.damped_members import tell_damped_members, tell_damped_roots
from vibcli.report.steps.from_modes import ALIKE, waves
from vibcli.report.steps.from_the_start import IN_TIME
from vibcli.report.steps.member_steady import ASKED, tell_steady_members
from vibcli.report.steps.member_waves import as_held, tell_waves
from vibcli.report.steps.step import WorkedSolution, number, told
from vibcli.symbolic.derivatives import gradient
from vibcli.symbolic.evaluation import Floats, evaluate
from vibcli.symbolic.rationals import fraction_of

if TYPE_CHECKING:
    from collections.abc import Sequence

    from numpy import ndarray

    from vibcli.analyses.modal.undamped import Mode
    from vibcli.report.blocks import Factor
    from vibcli.results.problem import Problem
    from vibcli.symbolic.node import Node

FIRST, LOOKED = 3, 12       # modes that are told, and among how many those that move are looked for
DAMPED = {"decay", "omega_d", "period_d", "zeta", "eigenvalue"}     # of modes that dampers make
HUNG_INDEX = re.compile(r"\b([A-Z])_[ij]")
PLACED = 0.8                # of a piece: where a shape is compared


class MovedMode(NamedTuple):
    """A mode, its modal mass in the normalisation of shapes, δ, p(0), ṗ(0), X at PLACED of
    the first piece, and [(X where it acts, a load)]."""

    mode: Any
    mass: float
    delta: float
    place: float
    speed: float
    middle: float
    loads: "Sequence[tuple[float, Node]]"

    @property
    def rate(self) -> float:
        """ω_d, of what does not die out within a swing."""
        return sqrt(max(float(self.mode.omega)**2 - self.delta**2, 0.0))


def tell_motion_of_members(problem: "Problem", sheet: WorkedSolution, equations: "Sequence[Any]") -> None:
    """Write down the motion in time where one is asked of what starts or is driven; `equations`: the frequency
    equations, none where they have no closed form."""
    if problem.numeric.has_free_symbols:
        return
    heads = {tree.head for answer in problem.spec.answers for tree in answer.asked.parts.quantities}
    started = problem.spec.get("initial") is not None or problem.spec.let_go
    swings = bool(heads & ASKED) and problem.spec.get("damping") is not None
    asked = heads & IN_TIME or "response" in (problem.spec.get("find") or ()) or swings
    if asked and (started or problem.scene.timed):
        before = [sheet.last]
        MotionOfMembers(problem, sheet).write(equations, before)
        tell_waves(problem, sheet, before, sheet.last > before[0])
        if sheet.last == before[0]:     # no modes that move by themselves, no waves
            tell_damped_members(problem, sheet)
    if heads & DAMPED:
        tell_damped_roots(problem, sheet)
    tell_steady_members(problem, sheet)


class MotionOfMembers:
    """The lines of the motion in time that a scene asks, after those of its modes."""

    def __init__(self, problem: "Problem", sheet: WorkedSolution) -> None:
        self.problem, self.sheet, self.scene, self.table = problem, sheet, problem.scene, problem.scene.table
        self.names = list(problem.scene.members)
        kinds = {member.kind.letter for member in problem.scene.members.values()}
        letter = next(iter(kinds)) if len(kinds) == 1 else "u"
        self.u, self.unit = GREEK.get(letter, letter), "rad" if letter == "phi" else "m"

    def write(self, equations: "Sequence[Any]", uses: "Sequence[int]") -> None:
        """Write down all of it; equations: the frequency equations, nothing where modes are not told apart."""
        try:
            self.modes = self._modes()
        except PhysicsError:
            return
        if not self.modes:
            return
        self.found = equations[0] if len(equations) == 1 else None
        told = [one.parts for one in orthogonality(self.problem, self.found)] if self.found else []
        lines = [self.sheet.write(Words("two modes are orthogonal:  "), *parts, settles="orthogonality", uses=uses)
                 for parts in told]
        lines.append(self._rule(told[0] if told else None, lines or list(uses)))
        told = [self._of_mode(one, lines) for one in self.modes]
        self._sum([*lines[-1:], *told])
        if self.problem.spec.get("damping") is not None:
            self._kept_up([*lines[-1:], *told])

    def _modes(self) -> list[MovedMode]:
        """The first ones that move."""
        import numpy as np

        from vibcli.results.modal_response import ModalResponse

        response = ModalResponse(self.problem)
        basis, felt, damping, start = response.apart(LOOKED)
        eta, rate = (np.where(abs(part) > ALIKE * np.max(abs(part), initial=0.0), part, 0.0) for part in start)
        if len({*basis.numbers}) < len(basis.numbers):
            return []
        loads, modes = response.loaded[0], self.problem.modal.modes.first(len(basis.squares))
        middle = basis.field(0, PLACED * basis.placed[0].piece.length)
        found = [self._moved(mode, felt[k], (damping[k] / 2, eta[k], rate[k], middle[k]), loads)
                 for k, mode in enumerate(modes) if mode.omega]
        least = ALIKE * max((_size(one) for one in found), default=0.0)
        return [one for one in found if _size(one) > least and isfinite(one.place) and one.rate][:FIRST]

    def _moved(self, mode: "Mode", felt: "ndarray", state: tuple[float, float, float, float],
               loads: Mapping[Any, Any]) -> MovedMode:
        scale, (delta, eta, rate, middle) = float(self.problem.modal.scale(mode)), state
        acting = [(float(felt[i]) * scale, node) for i, node in loads.items() if not node.is_zero]
        return MovedMode(mode, scale**2, float(delta), float(eta) / scale, float(rate) / scale, float(middle) * scale, [
            (x, node) for x, node in acting if abs(x) > ALIKE * abs(scale) * max(abs(felt))])

    def _rule(self, product: "tuple[Factor | str, ...]", uses: list[int]) -> int:
        """The line of the sum, and of the equation of each mode; product: parts of what two modes are orthogonal by."""
        damped, loaded = any(one.delta for one in self.modes), any(one.loads for one in self.modes)
        drag = [" + 2·δ_k·", Name("p_k'")] if damped else []
        right = "Q_k(t)/m_k" if loaded else "0"
        line = self.sheet.write(Words("so with  "), f"{self.u}(x, t) = Σ X_k(x)·p_k(t)", Words(
            "  each mode moves by itself:  "), Name("p_k''"), *drag, f" + ω_k²·p_k = {right}",
                                settles="modal equations", uses=uses)
        if product is not None:
            places, speeds = (any(getattr(one, what) for one in self.modes) for what in ("place", "speed"))
            dot = "" if places else "'"
            shown = own_letters(self.scene).text(self.u)
            of_mass, of_start = of_one_mode(product, Name(NAMES.get(shown, shown) + dot))
            by_loads = [Words(",  "), "Q_k", Words(" the loads, each by "), "X_k", Words(" where it acts")] * loaded
            self.sheet.write("m_k = ", *of_mass, *by_loads, settles="modal masses", uses=uses)
            if of_start and (places or speeds):
                alike = [Words(",  and of speeds alike")] * (places and speeds)
                self.sheet.write(Words("of the start  "), "m_k·", Name("p_k" + dot), "(0) = ", *of_start, *alike,
                                 *as_held(self.problem, self.u), joined=True, settles="modal start")
        return line

    def _of_mode(self, one: MovedMode, uses: list[int]) -> int:
        k, sheet = one.mode.index, self.sheet
        of_mass = "kg" if self.unit == "m" else "kg·m²"
        more = [Words(",  "), Name(sheet.letter(f"delta{k}")), *number(one.delta, "1/s"), Words(",  "),
                Name(sheet.letter(f"omega_d{k}")), *number(one.rate, "rad/s")] if one.delta else []
        line = sheet.write(Words(f"mode {k}:  "), *self._shape(one), f"m{lowered(k)}", *number(one.mass, of_mass),
                           *more, settles=f"modal mass {k}", value=one.mass, unit=of_mass, uses=uses)
        p = sheet.letter(f"p{k}")
        for dot, value, unit in (("", one.place, self.unit), ("'", one.speed, f"{self.unit}/s")):
            if value:
                sheet.write(Name(p + dot), "(0)", *number(value, unit), settles=f"p{dot}[{k}](0)", value=value,
                            unit=unit, joined=True)
        if one.loads:
            sheet.write(f"Q{lowered(k)} = ", self.table.total([self._rounded(x) * node for x, node in one.loads]),
                        settles=f"load of mode {k}", joined=True)
        return line

    def _shape(self, one: MovedMode) -> list[str | Words]:
        """Parts of X of a mode in numbers, and a comma."""
        k, shapes = one.mode.index, shape_in_numbers(self.problem, one.mode, "first", self.names) or {}
        if not all(len(found) == 1 for found in shapes.values()):
            return self._by_line(one, k)
        return [part for name, ((_, _, text),) in shapes.items() for part in (
            f"X{lowered(k)} = {text}", Words((f" of {name}" if len(shapes) > 1 else "") + ",  "))]

    def _by_line(self, one: MovedMode, k: int) -> list[Any]:
        """The same of one member whose shape a line before tells by βL but for its factor."""
        drawn = shape(self.found) if self.found is not None and hasattr(self.found, "standing") else None
        root = next((line.value for line in self.sheet.steps if line.settles == f"βL[{k}]"), None)
        if drawn is None or drawn.sigma is None or root is None:
            return []
        sigma, x = (self.table.parameter(name) for name in ("σ", self.found.wave_number.name))
        at = {**self.problem.numeric.floats, x.name: root, ALONG: PLACED * root}
        above, below = evaluate(list(drawn.sigma), Floats, at)
        first, second = evaluate([drawn.first, drawn.second], Floats, at)
        C = one.middle / (first - above / below * second)
        return [Words("with  "), sigma, " = " + told(above / below), Words(",  "), Name(self.sheet.letter("C1")),
                " = " + told(C), Words(",  ")]

    def _rounded(self, x: float) -> "Node":
        return self.table.number(fraction_of(float(f"{x:.6g}")))

    def _sum(self, uses: list[int]) -> None:
        """The sum of the modes, those under loads by the integral of their impulses."""
        parts: list[Any] = []
        for one in self.modes:
            k, X = one.mode.index, f"X{lowered(one.mode.index)}(x)·"
            sizes = one.place, (one.speed + one.delta * one.place) / one.rate
            if any(sizes):
                sign, first, *more = waves(self.scene, self.sheet, k, sizes, ALIKE * sum(map(abs, sizes)),
                                           bool(one.delta))
                if one.delta or len(more) == 1:
                    parts += [sign, *([X, first] if first[0] == "(" else [first, X]), *more]
                else:
                    parts += [" + ", X, "(", *([first] if sign == " + " else ["−", first]), *more, ")"]
        loaded = any(one.loads for one in self.modes)
        if loaded:
            words = Words("what a load brings about, the integral of its impulses from 0 to t:  ")
            self.sheet.write(words, self._impulses(), settles="loads of modes", uses=uses)
        if parts:
            first = parts[1:] if parts[0] == " + " else ["−", *parts[1:]]
            self.sheet.write(Words("so  "), f"{self.u}(x, t) = ", *first, " + …", Words(
                "  (and what the loads bring about)" * loaded), settles=f"motion of {self.u}", uses=uses)

    def _kept_up(self, uses: "Sequence[int]") -> None:
        """What a load of one frequency keeps up of each mode that is damped by itself."""
        try:
            found = waves_of_all(self.scene, {one.mode.index: self.table.total([
                self._rounded(x) * node for x, node in one.loads]) for one in self.modes if one.loads})
        except NotInLetters:
            return
        arguments = {argument for parts in found.values() for argument, _ in parts}
        if len(arguments) != 1:
            return
        floats, (argument,) = self.problem.numeric.floats, arguments
        rate = gradient(argument)[self.scene.time]
        Omega, = evaluate([rate], Floats, floats)
        letter = "Ω" if rate.name == "Omega" else plain.symbol(self.sheet.letter("Omega"))
        meant = [] if rate.name == "Omega" else [f"{letter} = ", rate, Words(",  ")]
        line = self.sheet.write(Words("once it is steady each mode has, by the amplitude of its load,  "), *meant,
                                f"P_k = Q_k/(m_k·√((ω_k² − {letter}²)² + 4·δ_k²·{letter}²))",
                                Words(",  and lags by  "), f"tan θ_k = 2·δ_k·{letter}/(ω_k² − {letter}²)",
                                settles="steady modes", uses=uses)
        for i, one in enumerate(one for one in self.modes if one.loads):
            k, square = one.mode.index, float(one.mode.omega)**2 - Omega**2
            size = hypot(*evaluate(list(found[k].values()), Floats, floats)) / one.mass / hypot(
                square, 2 * one.delta * Omega)
            self.sheet.write(f"P{lowered(k)}", *number(size, self.unit), Words(",  "), f"θ{lowered(k)}", *number(
                atan2(2 * one.delta * Omega, square), "rad"), settles=f"steady mode {k}", value=size, unit=self.unit,
                uses=[line], joined=i > 0)

    def _impulses(self) -> str:
        damped = any(one.delta for one in self.modes)
        decay, rate = ("exp(−δ_k·(t − τ))·", "ω_d,k") if damped else ("", "ω_k")
        return f"p_k = ∫ Q_k(τ)·{decay}sin({rate}·(t − τ))·dτ/(m_k·{rate})"


def _size(one: MovedMode) -> float:
    """How much a mode moves."""
    omega = float(one.mode.omega)
    return abs(one.place) + abs(one.speed) / omega + sum(abs(x) for x, _ in one.loads) / (one.mass * omega**2)


def of_one_mode(product: "Sequence[Any]", u: Name) -> "tuple[list[Factor | str], list[Factor | Name | str]]":
    """(parts of m_k, of m_k p_k(0)) by those of ∫ μ X_i X_j dx + … = 0; no second ones where bodies hang on
    members."""
    end = next(i for i, part in enumerate(product) if type(part) is str and part.startswith(" = 0"))
    of_mass, of_start, inside = [], [], False
    for part in product[:end]:
        text = part if type(part) is str else ""
        of_mass.append(HUNG_INDEX.sub(r"\1_k", text).replace("X_k·X_k", "X_k²") if text else part)
        if inside and text.startswith(")"):
            text, inside = ", 0" + text, False
        inside = inside or text.endswith(("X_j(", "X_j/∂x("))
        moved = text.replace("X_j·dx", "X_j(x, 0)·dx").replace("X_i", "X_k")
        first, *others = moved.split("X_j")
        of_start += [one for other in others for one in (u, other)] if text and not first else [
            first, *(one for other in others for one in (u, other))] if text else [part]
    hung = any(HUNG_INDEX.search(part) for part in of_start if type(part) is str and "X_" not in part)
    return of_mass, [] if hung else of_start

