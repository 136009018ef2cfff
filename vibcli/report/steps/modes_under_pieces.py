"""Several degrees of freedom under loads that begin, end and strike, or any other, in numbers, by the modes that
damping leaves apart:

    p̈ₖ + 2δₖ ṗₖ + ωₖ² pₖ = uₖᵀQ/(uₖᵀM uₖ),   q = Σ uₖ pₖ,   pₖ the sum of what the pieces of Q bring about,

and of what the start goes on as; of other loads the integral of their impulses (Thomson & Dahleh 1998, section 6.9)."""

from typing import TYPE_CHECKING, Any

from vibcli.report.blocks import Name, Words
from vibcli.report.steps.from_modes import ModeFromStart, mode_named, values_of_start
from vibcli.report.steps.held import SmallEquations
from vibcli.report.steps.loads_on_modes import LoadsOnModes, is_of_engine
from vibcli.report.steps.motion_by_pieces import MotionByModes, MotionByPieces, PartOfMode, ToldPiece
from vibcli.report.steps.pieces import KINDS, WAVES, LoadPiece
from vibcli.report.steps.small import AboutRest
from vibcli.report.steps.step import WorkedSolution, indexed, number, told
from vibcli.report.steps.unit_responses import UnitResponses, moving_freely
from vibcli.report.steps.waves_in_numbers import know_decay, with_numbers

if TYPE_CHECKING:
    from collections.abc import Sequence

    from vibcli.symbolic.node import Node

LETTERS = {"impulse": "h", "step": "s", "ramp": "r", "sin": "v", "cos": "w", "place": "d"}      # of unit responses
ROUNDED = 1e-9          # relative: of a load that swings as a mode that nothing damps
UNITS = "1/kg", "1/(kg·m)", "1/(kg·m²)"         # of what a mode has of loads, by how many coordinates turn
POSITIVE = "   (each from when its argument is positive)"


class ModesUnderPieces:
    """The lines of such a motion by real modes."""

    def __init__(self, about: AboutRest, sheet: WorkedSolution, found: SmallEquations, modes: "Sequence[ModeFromStart]",
                 loads: LoadsOnModes) -> None:
        self.about, self.sheet, self.modes, self.loads, self.table = about, sheet, modes, loads, about.table
        self.found, self.names, self.tau = found, about.scene.coordinates, about.letter(sheet.letter("tau"))
        self.units = ["m" if about.problem.system.dimension(name) else "rad" for name in self.names]
        self.damped, self._resists = any(mode.delta for mode in modes), []
        self.rest = [not any(getattr(mode, part) for mode in modes) for part in ("place", "speed")]
        M = about.problem.configuration.linear_system.matrices()[0]
        self.masses = [sum(value * mode.shape[i] * mode.shape[j] for (i, j), value in M.items()) for mode in modes]

    def write(self) -> bool:
        """Is all of it written down? Not where a load swings as a mode that nothing damps, nor what the engine does
        not find."""
        lines = [self._equation(mode, mass) for mode, mass in zip(self.modes, self.masses, strict=True)]
        if self.loads.pieces is None:
            self._integrals(lines)
            return True
        self.Omega = self.loads.frequency(self.about, self.sheet, lines)
        if self._resonates():
            return False
        lines += [line for kind in self._kinds() for line in self._unit(kind, lines)]
        lines = [self._sum(k, lines) for k in range(len(self.modes))]
        motions = [MotionByModes(MotionByPieces(self._of_all(i), self.tau, self.sheet.last + 1, None),
                                 self._parts_of(i)) for i in range(len(self.names))]
        for i, (name, motion) in enumerate(zip(self.names, motions, strict=True)):
            self._coordinate(i, motion, lines)
            self._know(i)
            self.sheet.by_pieces[name] = motion
        return all(is_of_engine(self.about, self.sheet, *pair) for pair in zip(self.names, motions, strict=True))

    def _kinds(self) -> dict[str, None]:
        """Of what begins: places and speeds of the start, and pieces of loads."""
        start = [kind for kind, rest in zip(("place", "impulse"), self.rest, strict=True) if not rest]
        return dict.fromkeys([*start, *(piece.kind for pieces in self.loads.pieces.values() for piece in pieces)])

    def _resonates(self) -> bool:
        Omega = None if self.Omega.is_zero else self.about.value(self.Omega)
        return Omega is not None and any(abs(mode.omega - Omega) <= ROUNDED * Omega and not mode.delta
                                         for mode in self.modes)

    def _p(self, k: int) -> Name:
        return Name(self.sheet.letter(f"p{self.modes[k].order}"))

    def _letter(self, letter: str, index: Any) -> "Node":
        return self.about.letter(self.sheet.letter(letter, index) if index == "k" else self.sheet.letter(
            f"{letter}{index}"))

    def _response(self, kind: str, index: Any, damped: bool) -> Any:
        """To a unit of a kind, by the letters of a mode."""
        omega, delta, omega_d = (self._letter(letter, index) for letter in ("omega", "delta", "omega_d"))
        unit = UnitResponses(self.table.one, omega ** 2, omega, delta, omega_d, self.tau, damped)
        if kind not in WAVES:
            return unit.of(kind)
        return unit.to_wave(kind, self.Omega, self._letter("R", index), self._letter("S", index) if damped else (
            self.table.zero))

    def _of_mode(self, kind: str, mode: Any) -> Any:
        """The same of a mode of this number; of one that moves freely that."""
        return self._response(kind, mode.order, bool(mode.delta)) if mode.omega else moving_freely(
            kind, self.tau, self.Omega)

    def _unit(self, kind: str, uses: "Sequence[int]") -> list[int]:
        """The lines of what a unit of a kind brings about."""
        resists = self._resistances(uses) if kind in WAVES and not self._resists else []
        self._resists = self._resists or resists
        name, free = self.sheet.letter(LETTERS[kind], "k"), [mode for mode in self.modes if not mode.omega]
        what = "the place 1, without a speed, goes on as  " if kind == "place" else (
            f"{KINDS[kind]} at τ = 0{',' * (kind in WAVES)} brings about in mode k, from rest,  ")
        told = [part for mode in free for part in (Words(
            f",  but in mode {mode.order}, which moves freely,  "), Name(
                self.sheet.letter(f"{LETTERS[kind]}{mode.order}")), "(τ) = ", self._of_mode(kind, mode))]
        return [*resists, self.sheet.write(Words(what), Name(name), "(τ) = ", self._response(
            kind, "k", self.damped), *told, settles=name, uses=[*uses, *resists])]

    def _resistances(self, uses: "Sequence[int]") -> list[int]:
        """The line of R and S of each mode that is brought back."""
        known, speed = [], self.about.value(self.Omega) or 0.0
        for mode in (mode for mode in self.modes if mode.omega):
            omega, delta, R, S = (self._letter(letter, mode.order) for letter in ("omega", "delta", "R", "S"))
            known.append((R, omega ** 2 - self.Omega ** 2, mode.omega**2 - speed**2))
            if mode.delta:
                known.append((S, 2 * delta * self.Omega, 2 * mode.delta * speed))
        for k, (letter, node, value) in enumerate(known):
            self.sheet.write(*[Words("the load meets  ")] * (k == 0), letter, " = ", node, *number(value, "1/s²"),
                             settles=letter.name, letter=letter.name, node=node, value=value, unit="1/s²", joined=k > 0,
                             uses=uses)
        return [self.sheet.last]

    def _sum(self, k: int, uses: "Sequence[int]") -> int:
        """The line of the normal coordinate of a mode."""
        pieces = self._pieces(k)
        parts = with_numbers(self.sheet, MotionByPieces(pieces, self.tau, 0, None).told(pieces, self.about.scene.time))
        return self.sheet.write(Words("so by superposition  "), self._p(k), " = ", *(parts or ["0"]), *[Words(
            POSITIVE)] * (k == 0), settles=self._p(k).text, uses=uses)

    def _coordinate(self, i: int, motion: Any, uses: "Sequence[int]") -> None:
        name = self.names[i]
        self.sheet.write(*([Words("and  ")] if i == 0 else []), Name(name), " = ", *motion.told([], None),
                         settles=f"motion of {name}", uses=uses, joined=i > 0)

    def _parts_of(self, i: int) -> list[PartOfMode]:
        return [PartOfMode(mode.shape[i], self._p(k)) for k, mode in enumerate(self.modes) if mode.shape[i]]

    def _integrals(self, uses: "Sequence[int]") -> None:
        """The lines of p under any loads, as the sum of the impulses that these consist of, and of the coordinates."""
        t, self.Omega = self.about.scene.time, self.table.zero
        kinds = ["impulse", *(["place"] * (not self.rest[0]))]
        lines = [*uses, *(line for kind in kinds for line in self._unit(kind, uses))]
        d, h, u, p, M, Q = *(self.sheet.letter(letter, "k") for letter in ("d", "h", "u", "p")), self.sheet.matrix(
            "M"), self.sheet.letter("Q")
        start: list[Any] = [part for rest, (one, dot) in zip(self.rest, ((d, ""), (h, "'")), strict=True) if not rest
                            for part in (Name(p + dot), "(0)·", Name(one), "(", t, ") + ")]
        lines = [self.sheet.write(Words("of the impulses from "), self.tau, " = 0", Words(" to "), t, Words(
            " that loads consist of  "), Name(p), " = ", *start, Words("∫ "), Name(h), "(", t, " − ", self.tau, ")·",
            Name(u), "·", Name(Q), "(", self.tau, ")/(", Name(u), "·", Name(M), "·", Name(u), ")·d", self.tau,
            settles="convolution", uses=lines)]
        for i in range(len(self.names)):
            self._coordinate(i, MotionByModes(MotionByPieces([], self.tau, lines[0], None), self._parts_of(i)), lines)

    def _equation(self, mode: Any, mass: float) -> int:
        """The line of a mode: its shape, the equation of its normal coordinate, and how that starts."""
        p, u, M, Q, order = *(Name(self.sheet.letter(f"{letter}{mode.order}")) for letter in "pu"), Name(
            self.sheet.matrix("M")), Name(self.sheet.letter("Q")), mode.order
        shape = [part for x, unit in zip(mode.shape, self.units, strict=True) for part in (
            ", ", told(x), *([Words(f"\u00a0{unit}/{self.units[0]}")] if x and unit != self.units[0] else []))][1:]
        omega = self._letter("omega", order)
        speed = [" + 2·", self._letter("delta", order), "·", Name(p.text + "'")] if mode.delta else []
        stiff = [" + ", omega ** 2, "·", p] if mode.omega else []
        loads = [part for i in self.loads.rows if mode.shape[i] for part in (
            " − " if mode.shape[i] < 0 else " + ", told(abs(mode.shape[i]) / mass), "·", Name(self.sheet.letter(
                indexed(Q.text, i + 1))))]
        loads = ["−" if loads[0] == " − " else "", *loads[1:]] if loads else ["0"]
        sides = [Words("of the right sides  "), Q, Words(",  ")] * (mode is self.modes[0])
        head = [*sides, *mode_named(self.about, self.sheet, order, mode is self.modes[0] and not all(self.rest))]
        line = self.sheet.write(
            *head, u, " = (", *shape, ")", Words(":  "), Name(p.text + "''"), *speed, *stiff, " = ", u, "·", Q, "/(", u,
            "·", M, "·", u, ") = ", *[part for part in loads if part != ""], *self._decay(mode), *self._start(mode),
            settles=f"equation of mode {order}", uses=self.found.lines)
        if mode.delta:
            know_decay(self.sheet, order, mode.delta, mode.rate, line)
        return line

    def _start(self, mode: Any) -> list[Any]:
        """Parts of p(0) and ṗ(0), where not all modes start at rest."""
        if all(self.rest):
            return []
        values = number(mode.place, self.units[0]), number(mode.speed, f"{self.units[0]}/s")
        return [Words(",  "), *values_of_start(self.sheet, mode.order, values, self.rest)]

    def _decay(self, mode: Any) -> list[Any]:
        """Parts of δ and ω_d of a mode that is damped."""
        if not mode.delta:
            return []
        return [Words(",  "), self._letter("delta", mode.order), *number(mode.delta, "1/s"), Words(",  "), self._letter(
            "omega_d", mode.order), *number(mode.rate, "rad/s")]

    def _weights(self, k: int, i: int | None) -> "list[tuple[str, float, str, Sequence[LoadPiece]]]":
        """[(the name of the factor of pₖ's part in a coordinate, of itself where i is None; its value, its unit, the
        pieces that it belongs to)] of the start and of the loads."""
        mode, of = self.modes[k], "p" if i is None else self.names[i]
        share, turned = (1.0, self.units[0]) if i is None else (mode.shape[i], self.units[i])
        begins = [(f"{of}{kind}", share * value, unit, [LoadPiece(kind, self.table.one, self.table.zero)])
                  for kind, value, unit in (("place", mode.place, turned), ("impulse", mode.speed, f"{turned}/s"))]
        return [(self.sheet.letter(f"g{k + 1}", name), value, unit, pieces) for name, value, unit, pieces in (
            *begins, *((f"{of}{j + 1}", share * mode.shape[j] / self.masses[k], UNITS[
                (turned == "rad") + (self.units[j] == "rad")], pieces) for j, pieces in self.loads.pieces.items()))]

    def _know(self, i: int) -> None:
        """Let the last line tell the letters of the weights of a coordinate."""
        for name, value, unit, _ in (one for k in range(len(self.modes)) for one in self._weights(k, i)):
            if value:
                self.sheet.write(settles=name, letter=name, value=abs(value), joined=True, uses=[self.sheet.last],
                                 unit=unit)

    def _of_all(self, i: int) -> list[ToldPiece]:
        return [piece for k in range(len(self.modes)) for piece in self._pieces(k, i)]

    def _pieces(self, k: int, i: int | None = None) -> list[ToldPiece]:
        """The pieces that a mode has in a coordinate; those of the normal coordinate where i is None."""
        mode, together = self.modes[k], {}
        for letter, weight, _, pieces in self._weights(k, i):
            self.sheet.in_numbers[letter] = abs(weight)
            name = self.table.parameter(letter)
            for piece in pieces if weight else ():
                key = piece.kind, piece.begins
                part = piece.factor * (name if weight > 0 else -name)
                together[key] = together.get(key, self.table.zero) + part
        return [ToldPiece(factor, begins, self._of_mode(kind, mode), self.sheet.letter(f"{LETTERS[kind]}{mode.order}"),
                          kind) for (kind, begins), factor in together.items()]
