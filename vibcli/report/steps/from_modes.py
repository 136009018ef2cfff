"""The free motion of several degrees of freedom from a given start, as the sum of its modes,

    q = Σ uₖ pₖ,   pₖ = e^{−δₖt} (Aₖ cos ωₖt + Bₖ sin ωₖt),   mₖ = uₖᵀM uₖ,   pₖ(0) = uₖᵀM q(0)/mₖ,

where nothing damps or what damps leaves the modes apart, and pₖ = pₖ(0) + ṗₖ(0)·t of what moves freely; and beats,
where two modes of one amplitude are close."""

from math import pi, sqrt
from typing import TYPE_CHECKING, Any

from vibcli.base.named_tuple import NamedTuple
from vibcli.report.blocks import Name, Words
from vibcli.report.steps.small import AboutRest
from vibcli.report.steps.step import WorkedSolution, number, told
from vibcli.report.steps.waves_in_numbers import NOTHING_KEPT, NumberedWave, know_decay, know_waves

if TYPE_CHECKING:
    from collections.abc import Mapping, Sequence

    from vibcli.report.steps.waves_in_numbers import KeptUpPart
    from vibcli.results.problem import Problem
    from vibcli.scene.scene import Scene
    from vibcli.symbolic.node import Node

ALIKE = 1e-9            # relative: of sums that vanish, and of amplitudes that are the same
ROUNDING = 1e-14        # relative: what sums of a few terms are off
CLOSE = 0.2             # of the difference of two frequencies over their sum, up to which they beat


class ModeFromStart(NamedTuple):
    """A mode from its start: its shape, frequency and δ, and p(0), ṗ(0), B."""

    order: int
    shape: "Sequence[float]"
    omega: float
    delta: float
    place: float
    speed: float

    @property
    def rate(self) -> float:
        """ω_d."""
        return sqrt(self.omega**2 - self.delta**2)

    @property
    def B(self) -> float:
        """The amplitude of the sine; of what moves freely the factor of the time."""
        return (self.speed + self.delta * self.place) / self.rate if self.omega else self.speed


def modes_of(problem: "Problem", start: "Sequence[Sequence[float]]") -> list[ModeFromStart]:
    """All modes with their parts of a start, places and speeds from rest; none where they neither oscillate nor move
    freely, or are coupled by damping."""
    names = problem.scene.coordinates
    M, C, _, K = problem.configuration.linear_system.matrices()
    found = []
    for mode in problem.modal.modes:
        u = [complex(x).real for x in problem.modal.shape(mode)]
        mass, damps = _form(M, u, u), _form(C, u, u)
        if mode.omega is None or _left(M, K, u, float(mode.omega)) > ALIKE or (
                damps / (2 * mass) >= mode.omega if mode.omega else damps):
            return []
        found.append(ModeFromStart(mode.index, u, float(mode.omega), damps / (2 * mass), *(
            _form(M, u, x) / mass for x in start)))
    return found if len(found) == len(names) and _apart(C, found) and _complete(found, start) else []


def _form(matrix: "Mapping[tuple[int, int], float]", one: "Sequence[float]", other: "Sequence[float]") -> float:
    """uᵀ M v, zero where rounding alone is left of its terms."""
    terms = [value * one[i] * other[j] for (i, j), value in matrix.items()]
    return _cleared(sum(terms), sum(map(abs, terms)), ROUNDING)


def _left(M: "Mapping[tuple[int, int], float]", K: "Mapping[tuple[int, int], float]", u: "Sequence[float]",
          omega: float) -> float:
    """How much of (K − ω²M) u is left, relative to its terms."""
    rows = {i for i, _ in (*M, *K)}
    size = max(sum(abs(value * u[j]) for (k, j), value in K.items() if k == i) for i in rows)
    return size and max(abs(sum(value * u[j] for (k, j), value in K.items() if k == i) - omega**2 * sum(
        value * u[j] for (k, j), value in M.items() if k == i)) for i in rows) / size


def _apart(C: dict[tuple[int, int], float], modes: "Sequence[ModeFromStart]") -> bool:
    """Does what damps leave the modes apart?"""
    return all(abs(_form(C, one.shape, other.shape)) <= ALIKE * sqrt(
        _form(C, one.shape, one.shape) * _form(C, other.shape, other.shape)) for one in modes for other in modes
        if one is not other)


def _complete(modes: "Sequence[ModeFromStart]", start: "Sequence[Sequence[float]]") -> bool:
    """Do the modes add up to the start?"""
    return all(abs(sum(mode.shape[i] * value for mode, value in zip(modes, values, strict=True)) - x) <= ALIKE * sum(
        map(abs, column)) for values, column in zip(
            ([mode.place for mode in modes], [mode.speed for mode in modes]), start, strict=True)
        for i, x in enumerate(column))


def tell_modes(about: AboutRest, sheet: WorkedSolution, modes: "Sequence[ModeFromStart]", uses: "Sequence[int]",
               kept: "Mapping[str, KeptUpPart]") -> None:
    """Write down their sum; `kept`: what is added to coordinates."""
    names = about.scene.coordinates
    rest = [not any(getattr(mode, part) for mode in modes) for part in ("place", "speed")]
    lines = [_start_of(about, sheet, mode, rest, uses) for mode in modes]
    moved = [mode for mode in modes if abs(mode.place) + abs(mode.B) > ALIKE * max(
        abs(one.place) + abs(one.B) for one in modes)]
    for i, name in enumerate(names):
        terms = [part for mode in moved for part in _terms(about, sheet, mode, mode.shape[i])]
        if terms or name in kept:
            line = motion_of(about, sheet, name, [*kept.get(name, NOTHING_KEPT).told, *terms], lines)
            size = [ALIKE * abs(mode.shape[i]) * (abs(mode.place) + abs(mode.B)) for mode in moved]
            know_waves(about, sheet, name, [NumberedWave(mode.order, mode.shape[i] * mode.place, mode.shape[i] * mode.B,
                                                         bool(mode.delta), nothing) for mode, nothing in zip(
                moved, size, strict=True)], kept.get(name, NOTHING_KEPT).waves, line)
        if terms and not kept:
            _beats(about, sheet, name, [(mode, mode.shape[i]) for mode in moved], line)


def _start_of(about: AboutRest, sheet: WorkedSolution, mode: ModeFromStart, rest: "Sequence[bool]",
              uses: "Sequence[int]") -> int:
    """The line of p(0) and ṗ(0) of a mode, and of δ and ω_d where it is damped; `rest`: are all of them zero?"""
    units = ["m" if about.problem.system.dimension(name) else "rad" for name in about.scene.coordinates]
    unit = next(one for one, x in zip(units, mode.shape, strict=True) if x)
    damped: list[Any] = []
    if mode.delta:
        delta, rate = (sheet.letter(f"{letter}{mode.order}") for letter in ("delta", "omega_d"))
        damped = [Words(",  "), Name(delta), *number(mode.delta, "1/s"), Words(",  "), Name(rate), " = ",
                  about.table.sqrt(_letter(about, sheet, "omega", mode) ** 2 - about.letter(delta) ** 2),
                  *number(mode.rate, "rad/s")]
    place, speed = (_cleared(mode.place, mode.speed / mode.omega), _cleared(mode.speed, mode.place * mode.omega)) if (
        mode.omega) else (mode.place, mode.speed)
    values = number(place, unit), number(speed, f"{unit}/s")
    if not mode.omega:
        p, omega = (sheet.letter(f"{letter}{mode.order}") for letter in ("p", "omega"))
        damped = [Words(",  and as "), Name(omega), " = 0", Words(" it moves freely,  "), Name(p), " = ", Name(p),
                  "(0) + ", Name(p + "'"), "(0)·", about.scene.time]
    shape = [part for one, x in zip(units, mode.shape, strict=True) for part in (
        ", ", told(x), *([Words(f"\u00a0{one}/{unit}")] if x and one != unit else []))][1:]
    line = sheet.write(*parts_of_start(about, sheet, mode.order, shape, values, rest), *damped,
                       settles=f"start of mode {mode.order}", value=mode.place, unit=unit, uses=uses)
    if mode.delta:
        know_decay(sheet, mode.order, mode.delta, mode.rate, line)
    return line


def parts_of_start(about: AboutRest, sheet: WorkedSolution, order: int, shape: "Sequence[Any]", values: "Sequence[Any]",
                   rest: "Sequence[bool]") -> list[Any]:
    """Parts of `with the shape of mode 1  u₁ = (…):  p₁(0) = u₁·M·q(0)/(u₁·M·u₁) = …,  ṗ₁(0) = …`, with
    the first also what q is; `rest`: is nothing moved, does nothing move?"""
    u = Name(sheet.letter(f"u{order}"))
    return [*mode_named(about, sheet, order, order == 1), u, " = (", *shape, ")", Words(":  "), *values_of_start(
        sheet, order, values, rest)]


def mode_named(about: AboutRest, sheet: WorkedSolution, order: int, first: bool) -> list[Any]:
    """Parts of `with the shape of mode 1  `, of the first told one with what q is."""
    if not first:
        return [Words(f"with the shape of mode {order}  ")]
    names = [part for name in about.scene.coordinates for part in (", ", Name(name))][1:]
    return [Words("with  "), Name(sheet.letter("q")), " = (", *names, ")", Words(
        f"  and the shape of mode {order}  ")]


def values_of_start(sheet: WorkedSolution, order: int, values: "Sequence[Any]", rest: "Sequence[bool]") -> list[Any]:
    """Parts of p₁(0) and ṗ₁(0) of these."""
    q, u, p, M = (Name(name) for name in (sheet.letter("q"), sheet.letter(f"u{order}"), sheet.letter(f"p{order}"),
                                          sheet.matrix("M")))
    parts: list[Any] = []
    for dot, value, still in zip(("", "'"), values, rest, strict=True):
        formula = [] if still else [" = ", u, "·", M, "·", Name(q.text + dot), "(0)/(", u, "·", M, "·", u, ")"]
        told = [*formula, *value]
        parts += [Words(",  " * bool(dot)), Name(p.text + dot), f"(0){told[0]}", *told[1:]]
    return parts


def _cleared(value: float, beside: float, left: float = ALIKE) -> float:
    """A value, zero where rounding alone is left beside another."""
    return 0.0 if abs(value) <= left * abs(beside) else value


def _letter(about: AboutRest, sheet: WorkedSolution, letter: str, mode: ModeFromStart) -> "Node":
    return about.letter(sheet.letter(f"{letter}{mode.order}"))


def _terms(about: AboutRest, sheet: WorkedSolution, mode: ModeFromStart, u: float) -> list[Any]:
    """[sign, part, …] of u pₖ."""
    if not mode.omega:
        values = [(u * mode.place, []), (u * mode.speed, ["·", about.scene.time])]
        return [part for value, more in values if value for part in (
            " − " if value < 0 else " + ", told(abs(value)), *more)]
    size = abs(mode.place) + abs(mode.B)
    return waves(about.scene, sheet, mode.order, (u * mode.place, u * mode.B), ALIKE * abs(u) * size, bool(mode.delta))


def waves(scene: "Scene", sheet: WorkedSolution, order: int, sizes: tuple[float, float], nothing: float,
          damped: bool) -> list[Any]:
    """[sign, part, …] of e^{−δₖt} (A cos ωₖt + B sin ωₖt), of which up to `nothing` is rounding."""
    table, t = scene.table, scene.time
    rate = table.parameter(sheet.letter(f"omega_d{order}" if damped else f"omega{order}")) * t
    waves = [(value, table.call(wave, rate)) for wave, value in zip(("cos", "sin"), sizes, strict=True)
             if abs(value) > nothing]
    if not waves:
        return []
    if not damped:
        return [part for value, wave in waves for part in (" − " if value < 0 else " + ", f"{told(abs(value))}·", wave)]
    decay = table.call("exp", -(table.parameter(sheet.letter(f"delta{order}")) * t))
    if len(waves) == 1:
        value, wave = waves[0]
        return [" − " if value < 0 else " + ", f"{told(abs(value))}·", wave, "·", decay]
    (one, cosine), (other, sine) = waves
    sign = " − " if one < 0 else " + "
    inner = [f"({told(abs(one))}·", cosine, " + " if one * other > 0 else " − ", f"{told(abs(other))}·", sine, ")"]
    return [sign, *inner, "·", decay]


def motion_of(about: AboutRest, sheet: WorkedSolution, name: str, terms: "Sequence[Any]", uses: "Sequence[int]") -> int:
    """Write down the motion of a coordinate as a sum of terms with signs."""
    sign, unit = [] if terms[0] == " + " else ["−"], "m" if about.problem.system.dimension(name) else "rad"
    return sheet.write(Words("so  "), Name(name), " = ", *sign, *terms[1:], Words(f"   (in {unit})"),
                       settles=f"motion of {name}", uses=uses)


def _beats(about: AboutRest, sheet: WorkedSolution, name: str, parts: list[tuple[ModeFromStart, float]],
           line: int) -> None:
    """The product of a slow and a fast wave that two cosines of one amplitude are."""
    if len(parts) != 2 or any(mode.delta or not mode.omega or abs(mode.B) > ALIKE * abs(mode.place)
                              for mode, _ in parts):
        return
    (one, u), (two, v) = parts
    a, b = u * one.place, v * two.place
    slow = abs(two.omega - one.omega)
    if abs(abs(a) - abs(b)) > ALIKE * abs(a) or slow > CLOSE * (one.omega + two.omega):
        return
    first, second = (_letter(about, sheet, "omega", mode) for mode in (one, two))
    waves = beating("cos" if a * b > 0 else "sin", first, second, about.scene.time)
    sheet.write(Words("which beats:  "), Name(name), f" = {'−' * (a < 0)}{told(2 * abs(a))}·", *waves, Words(
        ",  its amplitude comes back after  "), "2·π/(", second, " − ", first, ")", *number(2 * pi / slow, "s"),
        settles=f"beat_period({name})", node=2 * about.table.pi / (second - first), value=2 * pi / slow, unit="s",
        uses=[line])


def beating(wave: str, first: "Node", second: "Node", t: "Node") -> list[Any]:
    """Parts of cos ½(ω₂ − ω₁)t cos ½(ω₁ + ω₂)t, or of the sines."""
    return [f"{wave}((", second, " − ", first, ")·", t, f"/2)·{wave}((", first, " + ", second, ")·", t, "/2)"]
