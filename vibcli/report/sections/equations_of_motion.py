"""Energies and equations of motion, full and for small oscillations."""

from collections.abc import Iterator, Mapping, Sequence
from typing import TYPE_CHECKING, Any

from vibcli.base.errors import Kinked
from vibcli.mechanics.lagrange import nested_equations
from vibcli.notation.abbreviations import SHORTER, abbreviated
from vibcli.notation.equation_sides import equation, sides
from vibcli.notation.numbers import figure, with_minus
from vibcli.report import blocks
from vibcli.report.blocks import Heading, Name, Paragraph, Section, line, maths, paragraph, section, separated
from vibcli.report.keys import Key
from vibcli.report.sections.equilibrium import held
from vibcli.report.sections.members import member_energies, member_equations
from vibcli.report.sections.named_drives import named_drives
from vibcli.report.sections.too_long import brief
from vibcli.symbolic.evaluation import Floats, evaluate
from vibcli.symbolic.expression_graph import reachable

if TYPE_CHECKING:
    from vibcli.mechanics.lagrange import EquationsOfMotion
    from vibcli.report.blocks import Line
    from vibcli.report.document import Report
    from vibcli.results.problem import Problem
    from vibcli.symbolic.node import Node

# (name, letter, the one for it where the scene has that, title)
ENERGIES = (("T", "T", "E_kin", "Kinetic energy"), ("V", "V", "E_pot", "Potential energy"),
            ("Phi", "Φ", "Φ_R", "Dissipation function"))
WRITTEN_OUT = 16        # coordinates of a scene whose equations are printed in numbers


def energies(problem: "Problem", report: "Report") -> Iterator[Section]:
    drives, untold = named_drives(problem), True
    names = {*problem.scene.coordinates, *problem.scene.parameters.nodes}
    for key, letter, other, title in ENERGIES:
        symbol = other if key in names else letter
        node = problem.symbolic.energies[key] if drives is None else drives.energy(key)
        (shown,), lengths = abbreviated([node], report.roots)
        stands = drives.stands if drives is not None and untold and not {s for s, _ in drives.stands}.isdisjoint(
            reachable([node])) else []
        untold &= not stands
        further = member_energies(problem, key) if problem.scene.pieces else []
        if not shown.is_zero:
            yield from section(title, blocks.equations([line(f"{symbol} = ", brief(shown), *further, hang=2)]),
                               *with_lengths([*lengths, *stands]), *with_numbers(problem, [shown]),
                               *with_preloads(problem, [shown]))
        elif further:
            yield from section(title, blocks.equations([line(f"{symbol} = ", further[0].lstrip(" +"), *further[1:],
                                                             hang=2)]))


def with_lengths(lengths: "Sequence[tuple[Node, Node]]") -> list[Paragraph]:
    """Paragraphs that tell what new symbols of lengths stand for."""
    return [paragraph("with ", maths(symbol, " = ", length), hang=4, aside=True) for symbol, length in lengths]


def with_numbers(problem: "Problem", nodes: "Sequence[Node]") -> list[Paragraph]:
    """A paragraph that tells the numbers by which beams act at rest whose tension varies along them, if there are."""
    known = [node for node in reachable(nodes) if node in node.table.definitions]
    if not known:
        return []
    if problem.numeric.has_free_symbols:
        return [paragraph("with numbers of beams at rest whose tension varies along them", hang=4, aside=True)]
    values = zip(known, evaluate(known, Floats, problem.numeric.floats), strict=True)
    told = sorted(f"{node.name} = {with_minus(value)}" for node, value in values)
    return [paragraph(f"with, in SI units, as tensions vary along beams, {', '.join(told)}", hang=4, aside=True)]


def with_preloads(problem: "Problem", nodes: "Sequence[Any]") -> Iterator[Paragraph]:
    """Paragraphs that tell what the symbols of static preloads stand for, which open loops leave in the equations."""
    for symbol, record in problem.system.scene_with_multipliers.static_preloads:
        if symbol.name in {node.name for node in reachable(nodes) if node.op == "symbol"}:
            yield paragraph("with ", maths(symbol, " = ", brief(problem.system.preloads[record.name])), ", the "
                            f"{'moment' if 'torsion' in record else 'force'} of {record.name} at rest as drawn", hang=4,
                            aside=True)


WITHOUT = "without what `damping` adds: it acts in small oscillations alone"


def equations(problem: "Problem", report: "Report") -> Iterator[Section]:
    """The equations of motion; then those of small oscillations, in letters and in numbers."""
    if problem.scene.pieces:
        yield from member_equations(problem)
        return
    if not problem.system.scene_with_multipliers.q:
        return
    yield from _full(problem, report)
    found, coordinates = problem.symbolic.equations, problem.scene.coordinates
    if found.refusal and not (problem.system.sticking or isinstance(found.refusal, Kinked)):
        raise found.refusal
    if found.refusal:
        yield from _unbent(problem, report)
        return
    linear, drives = None, _drives(problem, found)
    numbers = not problem.numeric.has_free_symbols and len(coordinates) <= WRITTEN_OUT
    if found.linear:
        whole = "; in numbers below" if numbers else "; see --json"
        linear = blocks.equations(
            line(brief(node, whole), " = ", brief(drives[i], whole), label=Name(name))
            for i, (name, node) in enumerate(zip(coordinates, found.linear, strict=True)))
    drawn = problem.symbolic.balanced_as_drawn
    yield from section(
        "Small oscillations about the equilibrium" + ("" if drawn else ", the coordinates counted from it"), linear,
        Heading("in numbers (SI units):") if linear and numbers else None,
        blocks.equations(_in_numbers(problem, found)) if numbers else None, left_out(problem))


def _drives(problem: "Problem", found: "EquationsOfMotion") -> "list[Node]":
    """What drives each coordinate, displacements in time by their symbols where these are told."""
    table, named = problem.scene.table, named_drives(problem)
    drives = [found.drive.get(i, table.zero) for i in range(len(problem.scene.coordinates))]
    told = [None if named is None else named.drive(i, node) for i, node in enumerate(drives)]
    return [node if pairs is None else table.total([factor * symbol for factor, symbol in pairs])
            for node, pairs in zip(drives, told, strict=True)]


def left_out(problem: "Problem") -> Paragraph | None:
    """What of loads in time and of driven displacements the equations of small oscillations do not hold."""
    left_out, names = problem.symbolic.left_out, problem.scene.coordinates
    if not left_out:
        return None
    told = separated(maths(Name(names[i]), ":  ", node) for i, node in left_out.items())
    return paragraph("left out of the left side, as products of the coordinates and what drives them: ", *told,
                     "   (parametric excitation: `motion: full` keeps it)", hang=4, aside=True)


def _unbent(problem: "Problem", report: "Report") -> Iterator[Section]:
    """What is said instead of small oscillations where there is a kink."""
    if problem.system.sticking is not None and not report.tells("Equilibrium"):
        yield from section("Equilibrium", *held(problem))
    why = problem.symbolic.equations.refusal.message.partition(":")[0].replace(" in the equilibrium", " there")
    if problem.system.sticking is not None:
        why = "dry friction has a kink there"
    yield from section("Small oscillations", paragraph(f"none: {why}; `motion: full` follows the motion", hang=0))


def _full(problem: "Problem", report: "Report") -> Iterator[Section]:
    found, loose, title = problem.symbolic.equations, problem.system.scene_with_multipliers, "Equations of motion"
    if problem.spec.expanded:
        counted = "" if problem.symbolic.balanced_as_drawn else ", the coordinates counted from it"
        title += f", to the third order about the equilibrium{counted}"
    if found.unexpanded:
        yield from section(title, paragraph(f"none: {found.unexpanded.message} ({found.unexpanded.hint})", hang=0))
        return
    if not found.full:
        yield from section(title, paragraph(f"not written out for {len(problem.scene.coordinates)} coordinates"))
        return
    shown, lengths = abbreviated([*_told_as(problem, found, report.roots), *found.conditions], report.roots)
    labels = [*map(Name, found.names), *[None] * len(found.conditions)]
    lines, told_nodes = [], []
    for label, node in zip(labels, shown, strict=True):
        both = [brief(side) for side in sides(loose, node)]
        told_nodes += [side for side in both if hasattr(side, "op")]
        lines.append(line(both[0], " = ", both[1], label=label))
    if {symbol for symbol, _ in lengths}.isdisjoint(reachable(told_nodes)):
        for root in [root for root, one in report.roots.items() if one in dict(lengths)]:
            del report.roots[root]
        lengths = []
    told = []
    for symbol, name in found.multipliers.items():
        told += [", "] * bool(told) + [maths(symbol), f": the multiplier of '{name}'"]
    yield from section(title, blocks.equations(lines), *with_lengths(lengths), *with_preloads(problem, told_nodes),
                       paragraph(*told, hang=4, aside=True) if told else None,
                       paragraph(WITHOUT) if problem.spec.get("damping") is not None else None)


def _told_as(problem: "Problem", found: "EquationsOfMotion", known: "dict[Node, Node]") -> "Sequence[Node]":
    """The left sides: with the symbols of displacements in time, or as they come from the energies where these are
    shorter by far for the lengths in them."""
    if found.from_rest or problem.system.scene_with_multipliers is not problem.scene:
        return found.from_rest or found.full
    drives = named_drives(problem)
    if drives is not None:
        return [drives.equation(i) for i in range(len(found.full))]
    if problem.spec.expanded or not (abbreviated(found.full, lengths := dict(known))[1] or lengths):
        return found.full
    return [nested if _columns(nested, known) < SHORTER * _columns(full, known) else full
            for nested, full in zip(nested_equations(problem.scene.written), found.full, strict=True)]


def _columns(node: "Node", known: "Mapping[Node, Node]") -> int:
    """Those of an equation as it is told, with the lengths that are `known` and others."""
    from vibcli.notation.plain import plain

    return len(plain(abbreviated([node], dict(known))[0][0]))


def _in_numbers(problem: "Problem", found: "EquationsOfMotion") -> "Iterator[Line]":
    from vibcli.report.sections.numeric_equations import numeric_drive, numeric_rows

    rows = numeric_rows(problem, problem.configuration.told_matrices)
    named = named_drives(problem)
    for i, (name, row) in enumerate(zip(problem.scene.coordinates, rows, strict=True)):
        pairs = None if named is None else named.drive(i, found.drive.get(i, problem.scene.table.zero))
        drive = numeric_drive(problem, found, i) if pairs is None else [
            (evaluate([factor], Floats, problem.configuration.at_rest)[0], symbol) for factor, symbol in pairs]
        yield line(*numeric_sum(row), " = ", *numeric_sum(drive), label=Name(name))


def numeric_sum(row: "Sequence[tuple[float, Node]]") -> "Sequence[Any]":
    """Parts of Σ coefficient·node."""
    parts: list[Any] = []
    for value, node in row:
        sign = ("−" if value < 0 else "") if not parts else (" − " if value < 0 else " + ")
        if node.op == "number":
            parts.append(f"{sign}{figure(abs(value))}")
        else:
            parts += [sign + ("" if abs(value) == 1 else f"{figure(abs(value))}·"), node]
    return parts or ["0"]


ENERGY = Key("energies", "as expressions of the language of scenes, in solve and equations",
             lambda problem: problem.symbolic.energies, of=(
    Key("T", "kinetic energy"),
    Key("V", "potential energy, without constants"),
    Key("Phi", "dissipation function; 0 where nothing damps")))


def equation_rows(problem: "Problem") -> Iterator[dict[str, str | None]]:
    """What the keys below tell of each coordinate."""
    from vibcli.notation.latex import in_one_line
    from vibcli.notation.scene_language import language
    from vibcli.report.sections.numeric_equations import linear_rows

    equations, loose = problem.symbolic.equations, problem.system.scene_with_multipliers
    linear = [] if equations.refusal else list(linear_rows(problem, equations))
    for i, name in enumerate(equations.names):
        text, tex, missing = None, None, None
        if name in problem.scene.coordinates and not equations.refusal:
            row = problem.scene.coordinates.index(name)
            text, tex = linear[row]
            missing = equations.left_out.get(row)
        full = [equation(loose, equations.full[i], write) if equations.full else None
                for write in (language, in_one_line)]
        yield EQUATIONS.row(name, *full, text, tex, missing)


EQUATIONS = Key("equations", "a list, one entry to each coordinate", equation_rows, each=(
    Key("coordinate", "the coordinate"),
    Key("text", "the full equation of motion in the language of scenes, with motion: {order: 3} the expanded one; null "
        "where there is none"),
    Key("latex", "the same in LaTeX"),
    Key("linear_text", "the equation of small oscillations, the coordinates counted from equilibrium"),
    Key("linear_latex", "the same in LaTeX"),
    Key("left_out", "what its left side lacks, products of the coordinates and of loads in time or driven "
        "displacements, as text; null where there are none")))


def _matrices(problem: "Problem") -> "dict[str, list[list[float | Node | str]] | None]":
    """{name: rows} of numbers or of expressions, None where it is absent."""
    symbolic, indices = problem.numeric.has_free_symbols, range(len(problem.scene.coordinates))
    zero, matrices = ("0", problem.symbolic.matrices if problem.symbolic.linearisable else [{}] * 4) if symbolic else (
        0.0, problem.configuration.told_matrices)
    return MATRICES.row(*([[matrix.get((i, j), zero) for j in indices] for i in indices] if matrix else None
                          for matrix in matrices))


MATRICES = Key("matrices", "of M q'' + (C + G) q' + K q = 0: lists of rows, null where absent and of more than 2000 "
               "coordinates", _matrices, of=(
    Key("M", "mass matrix"), Key("C", "damping matrix, symmetric"), Key("G", "gyroscopic matrix, skew"),
    Key("K", "stiffness matrix")))
