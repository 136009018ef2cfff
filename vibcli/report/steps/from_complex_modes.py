"""The free motion of several degrees of freedom from a given start where damping couples their modes, as the sum of the
complex ones (Foss 1958),

    q = Σ aₖuₖ e^{λₖt},   aₖ = uₖᵀ(M q̇(0) + (λₖM + C) q(0)) / uₖᵀ(2λₖM + C)uₖ   of symmetric M, C and K."""

from typing import TYPE_CHECKING, Any

from vibcli.base.named_tuple import NamedTuple
from vibcli.report.blocks import Name, Words
from vibcli.report.steps.complex_numbers import complex_told, shape_told
from vibcli.report.steps.from_modes import ALIKE, motion_of, waves
from vibcli.report.steps.small import AboutRest
from vibcli.report.steps.step import WorkedSolution, number, told
from vibcli.report.steps.waves_in_numbers import NOTHING_KEPT, NumberedWave, know_decay, know_waves

if TYPE_CHECKING:
    from collections.abc import Mapping, Sequence

    from numpy import ndarray

    from vibcli.report.steps.waves_in_numbers import KeptUpPart
    from vibcli.results.problem import Problem

RULE = ("each complex mode has of the start its shape by (M·speeds + (λ·M + C)·places) over its shape by (2·λ·M + C) "
        "by its shape")
PAIRS = ", and a pair of roots adds twice the real part of one"


class ComplexMode(NamedTuple):
    """A root λ, of a pair the one above, its shape, and its part a of the start."""

    order: int
    root: complex
    shape: "ndarray"
    part: complex

    @property
    def sizes(self) -> "ndarray":
        """Of each coordinate A − iB of A cos ωt + B sin ωt; twice the real part of what is one of a pair."""
        return (2 if self.root.imag else 1) * self.part * self.shape


def tell_complex_modes(about: AboutRest, sheet: WorkedSolution, modes: "Sequence[ComplexMode]", uses: "Sequence[int]",
                       kept: "Mapping[str, KeptUpPart]") -> None:
    """Write down their sum; `kept`: what is added to coordinates."""
    pairs = any(mode.root.imag for mode in modes)
    lines = [sheet.write(Words(RULE + PAIRS * pairs), settles="parts of the start", uses=uses)]
    lines += [_part_of(about, sheet, mode, lines[:1]) for mode in modes]
    for i, name in enumerate(about.scene.coordinates):
        nothing = ALIKE * max(abs(mode.sizes[i]) for mode in modes)
        terms = [part for mode in modes for part in _terms(about, sheet, mode, i, nothing)]
        if terms or name in kept:
            line = motion_of(about, sheet, name, [*kept.get(name, NOTHING_KEPT).told, *terms], lines)
            if pairs and all(mode.root.imag for mode in modes):
                know_waves(about, sheet, name, [NumberedWave(
                    mode.order, complex(mode.sizes[i]).real, -complex(mode.sizes[i]).imag, True, nothing)
                    for mode in modes], kept.get(name, NOTHING_KEPT).waves, line)


def complex_modes_of(problem: "Problem", start: "Sequence[Sequence[float]]") -> list[ComplexMode]:
    """All of them with their parts of a start, places and speeds from rest; none where they are not all."""
    import numpy as np

    names, configuration = problem.scene.coordinates, problem.configuration
    damped = problem.modal.damped
    if damped is None:
        return []
    M, C, _, K = (_dense(entries, len(names)) for entries in configuration.linear_system.matrices())
    places, speeds = np.array(start, dtype=float)
    found = []
    for mode in damped:
        root = complex(mode.eigenvalue)
        shape = np.array([complex(x) for x in problem.modal.shape(mode)])
        whole, weight = [root**2 * M, root * C, K], shape @ (2 * root * M + C) @ shape
        left, size = np.abs(sum(whole) @ shape).max(), sum(np.abs(part) @ np.abs(shape) for part in whole).max()
        if left > ALIKE * size or not weight:
            return []
        part = shape @ (M @ speeds + (root * M + C) @ places) / weight
        found.append(ComplexMode(mode.index, root, shape, complex(part)))
    return found if _complete(found, places, speeds) else []


def _dense(entries: "Mapping[tuple[int, int], Any]", size: int) -> Any:
    import numpy as np

    found: Any = np.zeros((size, size))
    for place, value in entries.items():
        found[place] = value
    return found


def _complete(modes: "Sequence[ComplexMode]", places: "ndarray", speeds: Any) -> bool:
    """Do the modes add up to the start, place and speed?"""
    import numpy as np

    size = max(np.abs(places).max(), np.abs(speeds).max() / max(abs(mode.root) for mode in modes))
    return bool(size) and all(np.abs(sum((mode.sizes * mode.root**power).real for mode in modes) - given).max()
                              <= ALIKE * size * max(abs(mode.root) for mode in modes)**power
                              for power, given in ((0, places), (1, speeds)))


def _part_of(about: AboutRest, sheet: WorkedSolution, mode: ComplexMode, uses: "Sequence[int]") -> int:
    """The line of the shape of a mode and its part of the start."""
    names = about.scene.coordinates
    unit = "m" if about.problem.system.dimension(names[0]) else "rad"
    parts: list[Any] = [Words(f"of λ = {complex_told(mode.root)} 1/s:  ")]
    if mode.root.imag:
        for letter, value, of in (("delta", -mode.root.real, "1/s"), ("omega_d", mode.root.imag, "rad/s")):
            parts += [Name(sheet.letter(f"{letter}{mode.order}")), *number(value, of), Words(",  ")]
    told_of = [*shape_told(names, mode.shape), Words(",  its part is  "), complex_told(mode.part), Words(f" {unit}")]
    line = sheet.write(*parts, *told_of, settles=f"part {complex_told(mode.root)}", uses=uses)
    if mode.root.imag:
        know_decay(sheet, mode.order, -mode.root.real, mode.root.imag, line)
    return line


def _terms(about: AboutRest, sheet: WorkedSolution, mode: ComplexMode, i: int, nothing: float) -> list[Any]:
    """[sign, part, …] of what a mode adds to a coordinate."""
    size = complex(mode.sizes[i])
    if mode.root.imag:
        return waves(about.scene, sheet, mode.order, (size.real, -size.imag), nothing, True)
    if abs(size.real) <= nothing:
        return []
    rate = mode.root.real
    decay = [f"·exp({'−' * (rate < 0)}{told(abs(rate))}·", about.scene.time, ")"] if rate else []
    return [" − " if size.real < 0 else " + ", told(abs(size.real)), *decay]
