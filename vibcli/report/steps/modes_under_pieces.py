"""Several degrees of freedom from rest under loads that begin, end and strike, in numbers, by the modes that damping
leaves apart:

    p̈ₖ + 2δₖ ṗₖ + ωₖ² pₖ = uₖᵀQ/(uₖᵀM uₖ),   q = Σ uₖ pₖ,   pₖ the sum of what the pieces of Q bring about,

    unit impulse h = e^{−δτ} sin ω_dτ/ω_d,   unit step s = (1 − e^{−δτ} (cos ω_dτ + δ sin ω_dτ/ω_d))/ω²,

    unit ramp r = (τ − 2δ/ω² + e^{−δτ} (2δ cos ω_dτ/ω² + (δ² − ω_d²) sin ω_dτ/(ω²ω_d)))/ω²

(Thomson & Dahleh 1998, section 6.9)."""

from typing import TYPE_CHECKING

from vibcli.report.blocks import Name, Words
from vibcli.report.steps.from_modes import ModeFromStart, modes_of
from vibcli.report.steps.held import SmallEquations
from vibcli.report.steps.motion_by_pieces import MotionByModes, MotionByPieces, ToldPiece
from vibcli.report.steps.pieces import KINDS, LoadPiece, pieces_of
from vibcli.report.steps.small import AboutRest
from vibcli.report.steps.step import WorkedSolution, number, told
from vibcli.report.steps.unit_responses import UnitResponses
from vibcli.report.steps.waves_in_numbers import know_decay, with_numbers

if TYPE_CHECKING:
    from collections.abc import Mapping, Sequence

LETTERS = {"impulse": "h", "step": "s", "ramp": "r"}        # of unit responses
COUPLED = "damping couples the modes, so that what the pieces of the loads bring about is found in numbers alone"
MOST = 3                # coordinates whose motion is a line to read


def tell_modal_pieces(about: AboutRest, sheet: WorkedSolution, found: SmallEquations) -> None:
    """Write down all of it; nothing where the file gives a start, the modes do not stay apart, or loads are others."""
    problem, n = about.problem, len(about.scene.q)
    if problem.numeric.has_free_symbols or found.G or n > MOST or problem.spec.get("initial") is not None:
        return
    loads = {i: pieces_of(about.scene, load) for i, load in found.drive.items()}
    modes = modes_of(problem, [[0.0] * n, [0.0] * n])
    told_of = all(pieces is not None and all(piece.kind in LETTERS for piece in pieces) for pieces in loads.values())
    if modes and told_of:
        _ModesUnderPieces(about, sheet, modes, loads).write(found.lines)
    elif found.C and told_of:
        sheet.write(Words(COUPLED), settles="no superposition of modes", uses=found.lines)


class _ModesUnderPieces:
    def __init__(self, about: AboutRest, sheet: WorkedSolution, modes: "Sequence[ModeFromStart]",
                 loads: "Mapping[int, Sequence[LoadPiece]]"):
        self.about, self.sheet, self.modes, self.loads, self.table = about, sheet, modes, loads, about.table
        self.names, self.tau = about.scene.coordinates, about.letter(sheet.letter("tau"))
        self.units = ["m" if about.problem.system.dimension(name) else "rad" for name in self.names]
        self.damped = any(mode.delta for mode in modes)
        M = about.problem.configuration.linear_system.matrices()[0]
        self.masses = [sum(value * mode.shape[i] * mode.shape[j] for (i, j), value in M.items()) for mode in modes]
        self.kinds = list(dict.fromkeys(piece.kind for pieces in loads.values() for piece in pieces))

    def write(self, uses: "Sequence[int]") -> None:
        """Write down all of it."""
        lines = [self._equation(mode, mass, uses) for mode, mass in zip(self.modes, self.masses, strict=True)]
        k = self._unit("k", self.damped)
        for kind in self.kinds:
            head = Words(f"{KINDS[kind]} at τ = 0 brings about in mode k, from rest,  ")
            name = self.sheet.letter(LETTERS[kind], "k")
            lines.append(self.sheet.write(head, Name(name), "(τ) = ", k.of(kind), settles=name, uses=lines))
        time, several = self.about.scene.time, Words("   (each from when its argument is positive)")
        lines = [self.sheet.write(Words("so by superposition  "), self._p(k), " = ", *with_numbers(
            self.sheet, MotionByPieces(pieces, self.tau, 0, None).told(pieces, time)), *[several] * (k == 0),
            settles=self._p(k).text, uses=lines) for k in range(len(self.modes)) for pieces in [self._pieces(k)]]
        for i, name in enumerate(self.names):
            pieces = [piece for k in range(len(self.modes)) for piece in self._pieces(k, i)]
            modes = [(mode.shape[i], self._p(k)) for k, mode in enumerate(self.modes) if mode.shape[i]]
            motion = MotionByModes(MotionByPieces(pieces, self.tau, self.sheet.last + 1, None), modes)
            self.sheet.write(*([Words("and  ")] if i == 0 else []), Name(name), " = ", *motion.told(pieces, None),
                             settles=f"motion of {name}", uses=lines, joined=i > 0)
            self._know(i)
            self.sheet.by_pieces[name] = motion

    def _p(self, k):
        return Name(self.sheet.letter(f"p{self.modes[k].order}"))

    def _unit(self, index, damped):
        omega, *decays = (self._letter(letter, index) for letter in ("omega", "delta", "omega_d"))
        return UnitResponses(self.table.one, omega ** 2, omega, *decays, self.tau, damped)

    def _letter(self, letter, index):
        return self.about.letter(self.sheet.letter(letter, index) if index == "k" else self.sheet.letter(
            f"{letter}{index}"))

    def _equation(self, mode, mass, uses):
        """The line of a mode: its shape, and the equation of its normal coordinate."""
        p, u, M, Q, order = *(Name(self.sheet.letter(f"{letter}{mode.order}")) for letter in "pu"), Name(
            self.sheet.matrix("M")), Name(self.sheet.letter("Q")), mode.order
        shape = [part for x, unit in zip(mode.shape, self.units, strict=True) for part in (
            ", ", told(x), *([Words(f"\u00a0{unit}/{self.units[0]}")] if x and unit != self.units[0] else []))][1:]
        omega = self._letter("omega", order)
        speed = [" + 2·", self._letter("delta", order), "·", Name(p.text + "'")] if mode.delta else []
        loads = [part for i in self.loads if mode.shape[i] for part in (
            " − " if mode.shape[i] < 0 else " + ", told(abs(mode.shape[i]) / mass), "·", Name(f"{Q.text}{i + 1}"))]
        loads = ["−" if loads[0] == " − " else "", *loads[1:]] if loads else ["0"]
        line = self.sheet.write(
            Words("with the shape of mode "), str(order), Words("  "), u, " = (", *shape, ")", Words(":  "), Name(
                p.text + "''"), *speed, " + ", omega ** 2, "·", p, " = ", u, "·", Q, "/(", u, "·", M, "·", u, ") = ",
            *[part for part in loads if part != ""], *self._decay(mode), settles=f"equation of mode {order}", uses=uses)
        if mode.delta:
            know_decay(self.sheet, order, mode.delta, mode.rate, line)
        return line

    def _decay(self, mode):
        """Parts of δ and ω_d of a mode that is damped."""
        if not mode.delta:
            return []
        return [Words(",  "), self._letter("delta", mode.order), *number(mode.delta, "1/s"), Words(",  "), self._letter(
            "omega_d", mode.order), *number(mode.rate, "rad/s")]

    def _weight(self, k, i, j):
        """The letter, and the value, of uᵢₖ uⱼₖ over the modal mass: of a coordinate by a load on row j; uⱼₖ over that
        of the normal coordinate where i is None."""
        size = (1.0 if i is None else self.modes[k].shape[i]) * self.modes[k].shape[j] / self.masses[k]
        name = self.sheet.letter(f"g{k + 1}", f"{'p' if i is None else self.names[i]}{j + 1}")
        self.sheet.in_numbers[name] = abs(size)
        return name, size

    def _know(self, i):
        """Let the last line tell the letters of the weights of a coordinate."""
        for k in range(len(self.modes)):
            for j in self.loads:
                name, value = self._weight(k, i, j)
                turns = (self.units[i] == "rad") + (self.units[j] == "rad")
                self.sheet.write(settles=name, letter=name, value=abs(value), joined=True, uses=[self.sheet.last],
                                 unit=("1/kg", "1/(kg·m)", "1/(kg·m²)")[turns])

    def _pieces(self, k, i=None):
        """The pieces that a mode has in a coordinate; those of the normal coordinate where i is None."""
        order, together = self.modes[k].order, {}
        unit = self._unit(order, bool(self.modes[k].delta))
        for j, pieces in self.loads.items():
            letter, weight = self._weight(k, i, j)
            name = self.table.parameter(letter)
            for piece in pieces if weight else ():
                key = piece.kind, piece.begins
                part = piece.factor * (name if weight > 0 else -name)
                together[key] = together.get(key, self.table.zero) + part
        return [ToldPiece(factor, begins, unit.of(kind), self.sheet.letter(f"{LETTERS[kind]}{order}"), kind)
                for (kind, begins), factor in together.items()]
