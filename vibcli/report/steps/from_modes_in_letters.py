"""The free motion of two degrees of freedom from a start in letters, which damping leaves apart, as the sum of its
modes; and its beats."""

from typing import TYPE_CHECKING, Any

from vibcli.base.errors import PhysicsError
from vibcli.mechanics.initial_state import starts_in_letters
from vibcli.report.blocks import Factor, Name, Words
from vibcli.report.steps.free_waves import ToldMotion, from_start
from vibcli.report.steps.from_modes import beating, parts_of_start
from vibcli.report.steps.held import SmallEquations
from vibcli.report.steps.small import AboutRest
from vibcli.report.steps.step import WorkedSolution
from vibcli.symbolic.normal_form import is_zero

if TYPE_CHECKING:
    from collections.abc import Mapping, Sequence

    from vibcli.report.steps.free_waves import FreeWave
    from vibcli.symbolic.node import Node


def tell_in_letters(about: AboutRest, sheet: WorkedSolution, found: SmallEquations,
                    modes: "Sequence[tuple[Node, Sequence[Node]]]", uses: "Sequence[int]") -> None:
    """Write down the motion of each coordinate; `modes`: ω² and the shape of each."""
    start = None if found.G or found.drive or about.problem.spec.in_full else _start_in_letters(about)
    if start is None or not (is_zero(_between(found.C, *(u for _, u in modes))) if found.C else True):
        return
    told = [_mode_in_letters(about, sheet, found, k, *mode, start, uses) for k, mode in enumerate(modes, 1)]
    if None in told:
        return
    table, t = about.table, about.scene.time
    for i, name in enumerate(about.scene.coordinates):
        waves = [from_start(about.tidy(p * u[i]), about.tidy(v * u[i]), *rates)
                 for (p, v, *rates, _), (_, u) in zip(told, modes, strict=True)]
        node = table.total([wave.at(t) for wave in waves])
        line = sheet.write(Words("so  "), Name(name), " = ", node, settles=f"motion of {name}", node=node,
                           uses=[line for *_, line in told])
        sheet.waves[name] = ToldMotion([wave for wave in waves if not (wave.a.is_zero and wave.b.is_zero)], line)
        _beats_in_letters(about, sheet, name, waves, line)


def _between(matrix: "Mapping[tuple[int, int], Node]", one: "Sequence[Node]", other: Any) -> "Node":
    """uᵀ M v."""
    return one[0].table.total([node * one[i] * other[j] for (i, j), node in matrix.items()])


def _mode_in_letters(about: AboutRest, sheet: WorkedSolution, found: SmallEquations, k: int, square: Any, u: Any,
                     start: Any, uses: "Sequence[int]") -> "tuple[Node, Node, Node, Node, int] | None":
    """(p, ṗ, ω, δ, the line of its start); None of one that damping alone lets die out."""
    table, omega = about.table, about.letter(sheet.letter(f"omega{k}"))
    mass = _between(found.M, u, u)
    p, v = (about.tidy(_between(found.M, u, x) / mass) for x in start)
    delta = about.tidy(_between(found.C, u, u) / (2 * mass)) if found.C else table.zero
    if square.is_zero:
        if not delta.is_zero:
            return None
        omega = table.zero
    damped: list[Any] = []
    if not delta.is_zero:
        of_delta, rate = (about.letter(sheet.letter(f"{letter}{k}")) for letter in ("delta", "omega_d"))
        root = table.sqrt(omega ** 2 - of_delta ** 2)
        damped = [Words(",  "), of_delta, " = ", delta, Words(",  "), rate, " = ", root,
                  Words("   (under-damped)")]
    line = uses[-1]
    if not any(part.is_zero for part in u):
        shape = [part for x in u for part in (", ", x)][1:]
        rest = [all(x.is_zero for x in given) for given in start]
        told = parts_of_start(about, sheet, k, shape, ((" = ", p), (" = ", v)), rest)
        line = sheet.write(*told, *damped, settles=f"start of mode {k}", node=p, uses=uses)
    elif damped:
        line = sheet.write(Words(f"mode {k} is damped with"), *damped[1:], settles=f"damping of mode {k}", uses=uses)
    if not damped:
        return p, v, omega, delta, line
    for one, node in ((of_delta, delta), (rate, root)):
        sheet.write(settles=one.name, node=node, joined=True, letter=one.name)
    return p, v, rate, of_delta, line


def _beats_in_letters(about: AboutRest, sheet: WorkedSolution, name: str, waves: "list[FreeWave]", line: int) -> None:
    """The product of a slow and a fast wave that two cosines of one amplitude are."""
    one, other = waves
    alike = [sign for sign in (1, -1) if is_zero(one.a - sign * other.a)]
    if alike and not (one.a.is_zero or one.rate.is_zero) and all(
            wave.b.is_zero and wave.delta.is_zero for wave in waves):
        sheet.write(Words("which beats where the frequencies are near each other:  "), Name(name), " = ", Factor(
            2 * one.a), "·", *beating("cos" if alike == [1] else "sin", one.rate, other.rate, about.scene.time),
            settles=f"beats of {name}", uses=[line])


def _start_in_letters(about: AboutRest) -> "list[tuple[Node, Node]] | None":
    """[the places, the speeds] at t = 0 from rest, None where the file gives none in letters."""
    try:
        starts = starts_in_letters(about.problem.symbolic)
    except PhysicsError:
        return None
    return None if starts is None else list(zip(*starts, strict=True))
