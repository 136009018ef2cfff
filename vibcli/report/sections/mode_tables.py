"""Rows of the tables of modes: frequencies, damping, shapes."""

from cmath import polar as to_polar
from collections.abc import Callable, Sequence
from itertools import pairwise
from math import degrees, floor, log10, tau
from typing import TYPE_CHECKING, Any

from vibcli.notation.numbers import NEGATIVE, figure, rounded_up
from vibcli.report.blocks import Name, TableBlock, maths, paragraph, separated
from vibcli.report.sections.too_long import passed_over, places_told

if TYPE_CHECKING:
    from vibcli.analyses.modal.damped_modes import DampedMode
    from vibcli.analyses.modal.undamped import Mode

ZERO_MODES = {"free": "rigid-body mode", "held": "no linear restoring force", "falling": "unstable: V falls beyond the "
              "linear terms"}
GROWING = {"divergence": "unstable: grows", "flutter": "flutter: grows"}
NOTHING = 1e-12      # of an amplitude in a shape of which one is 1
MANY, LONGEST = 8, 12       # modes in columns; else amplitudes of a shape, and shapes


def repeated(modes: "Sequence[Mode]") -> dict[int, str]:
    """{index: to how many digits} of modes whose frequencies coincide within their bounds, which is all that is known:
    any mix of their shapes is a mode to those digits."""
    found = {}
    for a, b in pairwise(modes):
        bound = float(a.error + b.error)
        if a.kind == b.kind == "oscillation" and abs(float(b.omega - a.omega)) <= bound * float(b.omega):
            told = f"repeated to {floor(-log10(bound))} digits" if bound else "repeated"
            found |= {a.index: told, b.index: told}
    return found


def mode_row(mode: "Mode", kind: str | None = None, same: str = "") -> tuple[str, ...]:
    """A row of the table of natural frequencies: number, ω, f, T, error bound, remark."""
    number, error = str(mode.index), f"{rounded_up(mode.error):.0e}" if mode.error else "exact"
    if mode.rigid:
        return number, "0", "0", "∞", "exact", ZERO_MODES[kind]
    remark = same
    if mode.growth_rate is not None:
        rate = figure(float(mode.growth_rate), mode.error).replace("-", "−", mode.growth_rate < 0)
        remark = f"{GROWING.get(mode.kind, 'decays')} as exp({rate}·t)"
    if not mode.omega:
        return number, "–", "–", "–", error, remark
    omega = float(mode.omega)
    return number, *(figure(x, mode.error) for x in (omega, omega / tau, tau / omega)), error, remark


def damped_row(mode: "DampedMode") -> tuple[str, ...]:
    error = f"{rounded_up(mode.error):.0e}" if mode.error else "exact"
    note = {"ζ = 1": "critically damped", None: ""}.get(mode.note, mode.note)
    if not note and mode.omega_d is None and mode.omega:
        note = "real eigenvalue"
        if mode.zeta is not None:
            note = f"over-damped, λ = {_set(figure(_float(mode.eigenvalue.real), mode.error))} 1/s"
    if mode.growth_rate:
        note = "flutter" if mode.kind == "flutter" else "unstable"
    of_decay, of_omega_d = mode.bounds
    return (str(mode.index), figure(_float(mode.omega), mode.error), figure(_float(mode.zeta), of_decay),
            figure(_float(mode.omega_d), of_omega_d),
            figure(float(mode.omega_d) / tau, of_omega_d) if mode.omega_d else "–",
            figure(tau / float(mode.omega_d), of_omega_d) if mode.omega_d else "–",
            figure(_float(mode.decay), of_decay), error, note)


def _float(value: float | None) -> float | None:
    return None if value is None else float(value)


def _real(value: float) -> str:
    value = complex(value).real
    return figure(0.0 if abs(value) < NOTHING else value)


def polar(value: complex) -> str:
    """5.2 ∠ −3.1°; 0 of what `_real` takes for rounding, too."""
    if abs(complex(value)) < NOTHING:
        return "0"
    size, angle = to_polar(complex(value))
    return f"{size:.4g} ∠ {_set(f'{degrees(angle):.4g}')}°" if abs(degrees(angle)) > 1e-9 else f"{size:.4g}"


def _set(figures: str) -> str:
    """A number among other signs as it is set in print."""
    return NEGATIVE.sub("−", figures)


def shapes_told(count: int) -> int:
    """Of how many modes the shapes are told where there are so many."""
    return min(count, LONGEST) if count > MANY else count


def shapes(names: Sequence[str], numbers: Sequence[int], found: Sequence[list[complex]],
           write: Callable[..., str] = _real) -> list[Any]:
    """Blocks of the shapes of modes of these numbers, the first `shapes_told` of them: a column a mode, or a line a
    mode where there are many, of many coordinates at evenly spread ones."""
    names = list(names)
    if len(numbers) > MANY:
        places = places_told(len(names), LONGEST, LONGEST)
        spread = ["at ", *separated(maths(Name(names[i])) for i in places)]
        return [paragraph(*spread) if len(places) < len(names) else None,
                *(paragraph(f"mode {i}: " + " ".join(write(shape[place]) for place in places), hang=None)
                  for i, shape in zip(numbers[:LONGEST], found, strict=False)),
                paragraph("…", hang=None) if len(numbers) > LONGEST else None]
    rows: list[tuple[Any, ...]] = [(maths(Name(names[i])), *(write(shape[i]) for shape in found))
                                   for i in places_told(len(names))]
    return [TableBlock(("", *(f"mode {i}" for i in numbers)), tuple(rows)), passed_over(len(rows), len(names))]
