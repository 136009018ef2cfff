"""How the frequency of free motions hangs on their amplitude."""

from collections.abc import Iterator
from math import tau
from typing import TYPE_CHECKING, Any

from vibcli.base.errors import PhysicsError
from vibcli.notation.numbers import figure, rounded_up
from vibcli.quantities.expression import number_of
from vibcli.report.blocks import Section, TableBlock, equations, line, paragraph, section
from vibcli.report.keys import Key
from vibcli.report.sections.insight import require_numbers
from vibcli.report.sections.parameters import unit
from vibcli.report.sections.requested_signals import dimension_of, symbol, trees_asked

if TYPE_CHECKING:
    from vibcli.plots.figure import Figure
    from vibcli.report.blocks import Equations, Paragraph
    from vibcli.report.document import Report
    from vibcli.results.problem import Problem
    from vibcli.symbolic.node import Node
    from vibcli.symbolic.syntax import NameRef, Sum

WORD, ROWS, POINTS = "backbone", 10, 101
SUBSCRIPTS = str.maketrans("0123456789", "₀₁₂₃₄₅₆₇₈₉")


def _asked(problem: "Problem") -> "tuple[str, NameRef | Sum, str, float, Any]":
    """(text, tree, unit, largest amplitude) of the signal whose amplitude is asked for, and the family's number."""
    require_numbers(problem, WORD)
    find = problem.spec.get("find")
    record = find.about(WORD) if find is not None else None
    if record is None:
        name = next(iter(problem.scene.coordinates), None)
        if name is None:
            from vibcli.mechanics.system import nothing_moves

            raise nothing_moves()
        most = problem.spec.example("10 cm") if problem.system.dimension(name) else "0.5"
        raise PhysicsError("it is not known up to which amplitude the backbone curve goes",
                           f"ask with find: [{{backbone: {{of: [{name}], up_to: {most}}}}}]")
    (text, tree), *_ = trees_asked(problem, WORD)
    most = number_of(problem, record["up_to"].tree)
    return text, tree, unit(dimension_of(problem, tree)), most, record.get("mode", 1)


def backbone(problem: "Problem", _: "Report") -> Iterator[Section]:
    if problem.numeric.has_free_symbols and len(problem.scene.resting.q) == 1:
        yield from _in_letters(problem)
        return
    text, tree, of, most, mode = _asked(problem)
    points, resonance = problem.free_motions.curve(mode, tree, [most * k / ROWS for k in range(1, ROWS + 1)])
    small, name, kappa = _small(problem, mode), _omega(mode), _kappa(problem, text, mode)
    head = (f"amplitude of {symbol(text)}" + f" [{of}]" * bool(of), "ω [rad/s]", "f [Hz]", "T [s]", f"ω/{name}",
            "energy [J]", "relative error ≤")
    rows = [(figure(one.amplitude), figure(one.omega, one.error), figure(one.omega / tau, one.error),
             figure(tau / one.omega, one.error), figure(one.omega / small) if small else "–", figure(one.energy),
             figure(rounded_up(one.error), digits=1)) for one in points]
    if kappa is not None and small:
        head = (*head[:2], _early(problem, name), *head[2:])
        rows = [(*row[:2], figure(small * (1 + kappa * one.amplitude**2)), *row[2:])
                for row, one in zip(rows, points, strict=True)]
    told = "The amplitude is half the range of the signal; the energy is counted from the equilibrium."
    left = [name for name in ("dampers", "damping") if problem.spec.get(name)]
    yield from section(
        "Free motions by their amplitude (backbone curve)", TableBlock(head, tuple(rows)), paragraph(told),
        paragraph("The dampers are left out.") if left else None, paragraph(resonance) if resonance else None,
        paragraph(f"Interrupted: {len(points)} of {ROWS} motions were found.") if problem.work.interrupted else None,
        paragraph(f"Small vibrations have {name} = {figure(small)} rad/s.") if small else paragraph(
            "There are no small vibrations about the equilibrium to compare with."),
        *_begins(problem, mode, kappa, of) if kappa is not None and small else (),
        *_exactly(problem) if list(problem.scene.coordinates) == [text] else ())


def _begins(problem: "Problem", mode: int, kappa: float | None, of: str) -> "Iterator[Equations | Paragraph]":
    """How the frequency begins to hang on the amplitude, in letters where these are known."""
    value = "" if kappa is None else figure(kappa) + f" 1/{of}²" * bool(of)
    own = _letter(problem, "kappa")
    early = _early(problem, _omega(mode))
    yield paragraph(f"At small amplitudes {_letter(problem, 'A')}, ω ≈ {early} by the method of "
                    "Lindstedt and Poincaré:")
    try:
        found = problem.free_motions.kappa_in_letters(1)
        told = [f" = {value}"] * bool(value)
        yield equations([line(own, *([" = ", found] if not (told and found.is_zero) else []), *told)])
    except PhysicsError:
        if kappa is None:
            raise
        yield equations([line(f"{own} = {value}")])
    several = problem.free_motions.several
    if several is not None and (near := several.near_resonance(mode)):
        yield paragraph(near)


def _early(problem: "Problem", name: str) -> str:
    return f"{name}(1 + {_letter(problem, 'kappa')}{_letter(problem, 'A')}²)"


def _letter(problem: "Problem", usual: str) -> str:
    """The usual letter of a formula, or one for which the scene has no other meaning."""
    return symbol(_free_name(problem, usual))


def _free_name(problem: "Problem", usual: str) -> str:
    taken = {*problem.scene.parameters.nodes, *problem.scene.coordinates}
    return next(name for name in (usual, *(f"{usual}_{i}" for i in range(len(taken) + 1))) if name not in taken)


def _exactly(problem: "Problem") -> "Iterator[Equations | Paragraph]":
    """The closed form, where the equilibrium is known in letters and there is one."""
    from vibcli.analyses.nonlinear.closed_forms import ByGamma, closed_form

    try:
        found = closed_form(problem.symbolic, problem.scene.table.parameter(_free_name(problem, "A")))
    except PhysicsError:
        return
    K, s, p, E = (_letter(problem, usual) for usual in "KspE")
    if isinstance(found, ByGamma):
        yield paragraph(f"Exactly, V being a pure power {p} of the deviation and Γ the gamma function:")
        yield equations([line(f"ω = √π Γ(½ + 1/{p})/(2 Γ(1 + 1/{p})) · ", found.rate), line(f"{p} = ", found.p),
                         line(f"{E} = ", found.energy)])
    elif found is not None:
        yield paragraph(f"Exactly, short of a top of V, {K} = ∫ dθ/√(1 − {s} sin² θ) from 0 to π/2 being the "
                        "complete elliptic integral of the first kind:")
        yield equations([line(f"ω = π/(2 {K}) · ", found.rate), line(f"{s} = ", found.m),
                         line(f"{E} = ", found.energy)])


def _in_letters(problem: "Problem") -> Iterator[Section]:
    """Of a scene in letters with one degree of freedom."""
    from vibcli.analyses.nonlinear.small_amplitudes import omega_in_letters

    _require_alone(problem)
    exactly, name = list(_exactly(problem)), _omega(1)
    try:
        small = [equations([line(f"{name} = ", omega_in_letters(problem.symbolic))]), *_begins(problem, 1, None, "")]
    except PhysicsError:
        if not exactly:
            raise
        small = []
    A, E = (_letter(problem, usual) for usual in "AE")
    energy = f", {E} the energy above that of the equilibrium" * bool(exactly)
    yield from section(
        "Free motions by their amplitude (backbone curve)", *small, *exactly,
        paragraph(f"{A} is the amplitude of {symbol(problem.scene.coordinates[0])}, half its range{energy}; a table of "
                  "frequencies needs numbers."))


def _require_alone(problem: "Problem") -> None:
    """PhysicsError where another family than the first is asked for."""
    find = problem.spec.get("find")
    record = find.about(WORD) if find is not None else None
    problem.free_motions.require_alone(1 if record is None else record.get("mode", 1))


def _kappa_in_letters(problem: "Problem") -> "Node | None":
    _require_alone(problem)
    try:
        return problem.free_motions.kappa_in_letters(1)
    except PhysicsError:
        return None


def _kappa(problem: "Problem", text: str, mode: int) -> float | None:
    """κ where the amplitude is that of a coordinate; None where there is none."""
    from vibcli.symbolic.running_errors import UNIT, number_in

    if text not in problem.scene.coordinates:
        return None
    try:
        return float(number_in(problem.free_motions.kappa(mode, text, None, UNIT)))
    except PhysicsError:
        return None


def _omega(number: int) -> str:
    return "ω" + str(number).translate(SUBSCRIPTS)


def _small(problem: "Problem", number: int) -> float | None:
    """ω of small vibrations of a mode; None where they have none."""
    try:
        mode = problem.modal.modes.first(number)[number - 1]
    except PhysicsError:
        return None
    return float(mode.omega) if mode.omega else None


def curve_figure(problem: "Problem") -> "Figure":
    """The amplitude over ω, as backbone curves are drawn."""
    from vibcli.plots.figure import Curve, Figure, Panel
    from vibcli.plots.prefixes import labelled, readable

    text, tree, of, most, mode = _asked(problem)
    points = problem.free_motions.curve(mode, tree, [most * k / (POINTS - 1) for k in range(1, POINTS)]).points
    factor, readable_unit = readable(most, of)
    small = _small(problem, mode)
    start = [(0.0, small)] if small else []
    y, x = zip(*start, *((one.amplitude * factor, one.omega) for one in points), strict=True)
    guide = [Curve("", (small, small), (0.0, y[-1]), "guide", ("", _omega(mode)))] if small else []
    panel = Panel(labelled("ω", "rad/s"), labelled(f"amplitude of {symbol(text)}", readable_unit),
                  curves=(*guide, Curve("", x, y)), x_range=_around(x), y_range=(0.0, 1.05 * y[-1]))
    return Figure(problem.spec.get("title") or "", (panel,))


def _around(values: tuple[float, ...]) -> tuple[float, float]:
    """A range with some room on both sides."""
    low, high = min(values), max(values)
    room = 0.06 * (high - low) or 0.1 * high
    return low - room, high + room


def _found(problem: "Problem") -> dict[str, float | list[dict[str, float]] | str]:
    if problem.numeric.has_free_symbols and len(problem.scene.resting.q) == 1:
        (text, tree), *_ = trees_asked(problem, WORD)
        of, known = unit(dimension_of(problem, tree)), list(problem.scene.coordinates) == [text]
        return KEY.row(text, of, _kappa_in_letters(problem) if known else None, [])
    text, tree, of, most, mode = _asked(problem)
    points = problem.free_motions.curve(mode, tree, [most * k / ROWS for k in range(1, ROWS + 1)]).points
    return KEY.row(text, of, _kappa(problem, text, mode), [dict(one._asdict()) for one in points])


KEY = Key(WORD, "frequency of free motions by their amplitude", _found, of=(
    Key("signal", "the signal whose amplitude counts"),
    Key("unit", "its unit"),
    Key("kappa", "κ of ω ≈ ωᵢ(1 + κA²) at small amplitudes of a coordinate, an expression of a scene in letters; "
                 "null of other signals, and where there is none"),
    Key("points", "a list, one entry to each amplitude, empty of a scene in letters", each=(
        Key("amplitude", "half the range of the signal"),
        Key("omega", "angular frequency [rad/s]"),
        Key("energy", "energy above that of the equilibrium [J]"),
        Key("error", "bound of the relative error of omega")))))
