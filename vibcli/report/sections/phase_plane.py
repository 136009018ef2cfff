"""The phase plane of one degree of freedom: its equilibria by their kinds, and the motion from the start."""

from collections.abc import Iterable, Iterator, Mapping
from itertools import pairwise
from math import inf
from typing import TYPE_CHECKING, Any

from vibcli.notation.numbers import figure, supported, with_unit
from vibcli.report.blocks import Name, Section, TableBlock, Words, maths, paragraph, section
from vibcli.report.keys import Key
from vibcli.report.sections.equilibria import search_told
from vibcli.report.sections.illustrations import plot
from vibcli.report.sections.parameters import unit
from vibcli.report.sections.requested_signals import symbol

if TYPE_CHECKING:
    from fractions import Fraction

    from vibcli.plots.figure import Figure
    from vibcli.report.blocks import Paragraph
    from vibcli.report.document import Report
    from vibcli.results.phase_plane import PhasePlane
    from vibcli.results.problem import Problem

LINES = (("own", "from the initial state", False), ("separatrix", "separatrix", False),
         ("into", "into a saddle", True), ("out of", "out of a saddle", False), ("cycle", "limit cycle", False))
MARKERS = ("", "centre", "focus", "node", "saddle")     # one for each kind; "": for any other
SAME = 1e-12                                        # of it: saddles of one energy
BEYOND = "terms beyond the linear ones decide"
TAKEN = {"full": "of the full equations", "expanded": "of the equations to the third order in the deviations from "
         "equilibrium"}


def phase_plane(problem: "Problem", report: "Report") -> Iterator[Section]:
    """A table of the equilibria, what is shown, how the motion from the start goes."""
    plane = problem.phase_plane
    low, high = plane.frame.q
    dimension = problem.system.dimension(plane.name)
    told = TAKEN["expanded" if problem.spec.expanded else "full"]
    yield from section(
        "Phase plane", _table(plane, unit(dimension)) if plane.portrait.equilibria else paragraph("no equilibrium"),
        paragraph(f"Shown, {told}: ", maths(Name(plane.name), Words(
            f" from {with_unit(low, dimension)} to {with_unit(high, dimension)}")), "."),
        search_told(problem, plane.equilibria.search) if plane.portrait.equilibria else None,
        plot("phase-plane", "The phase plane", plane_figure(problem)) if report.pictures else None)
    if plane.own is not None:
        yield from section("The motion from the initial state", *_own(plane, dimension))


def _table(plane: "PhasePlane", of: str) -> TableBlock:
    energies = plane.portrait.energies
    head = (maths(Name(plane.name), Words(f" [{of}]" * bool(of))), "", "λ [1/s]",
            *(("energy [J]",) if energies is not None else ()), "")
    rows = []
    for i, one in enumerate(plane.portrait.equilibria):
        place = figure(one.q) if one.span is None else " … ".join(map(figure, one.span))
        rows.append((place, one.kind, _eigenvalues(one.eigenvalues),
                     *((figure(energies[i]),) if energies is not None else ()),
                     BEYOND if one.degenerate and one.eigenvalues and one.span is None else
                     "the forces bend there" if one.eigenvalues is None else ""))
    return TableBlock(head, tuple(rows))


def _eigenvalues(pair: Any) -> str:
    """`−0.3 ± 3.1 i`, or both."""
    if pair is None:
        return "–"
    low, high = pair
    if not low.imag:
        return figure(low.real) if low == high else ", ".join(_signed(value.real) for value in pair)
    imaginary = f"± {figure(high.imag)} i"
    return f"{_signed(low.real)} {imaginary}" if low.real else imaginary


def _signed(number: float) -> str:
    return figure(number).replace("-", "−")


def _own(plane: "PhasePlane", dimension: "Mapping[str, Fraction | int]") -> "Iterator[Paragraph]":
    """Paragraphs on the motion from the start."""
    own = plane.own
    if own.turns is not None:
        yield paragraph("It turns at ", maths(Name(plane.name), Words(
            f" = {with_unit(own.turns[0], dimension)} and {with_unit(own.turns[1], dimension)}")),
            "; it comes back after " + supported(own.period[0], own.period[0] * own.period[1]) + " s."
            if own.period else f"; {own.reason}.")
    elif own.end is not None:
        yield paragraph(f"It ends in the {own.end.kind} at ", maths(Name(plane.name), Words(
            f" = {with_unit(own.end.q, dimension)}")), ".")
    elif own.reason is not None:
        yield paragraph(f"{own.reason[0].upper()}{own.reason[1:]}.")
    if own.energy is not None:
        yield paragraph(f"Its energy{'' if plane.conservative else ' at first'}, over that of the lowest equilibrium: "
                        f"{figure(own.energy)} J.")


def plane_figure(problem: "Problem") -> "Figure":
    """The phase plane as a Figure."""
    from vibcli.plots.phase_plane import PlaneLines, of_phase_plane

    plane = problem.phase_plane
    of = unit(problem.system.dimension(plane.name))
    roles = {role: [(one.q, one.v) for one in plane.portrait.branches if one.role == role]
             for role in ("orbit", *(role for role, *_ in LINES))}
    taken = "into" if roles["into"] else "separatrix"
    lines = [PlaneLines(label if roles[role] else "", roles[role], at_end=at_end) for role, label, at_end in LINES
             if role not in {"into", "separatrix"} - {taken}]
    spans = [(one.span, (0.0, 0.0)) for one in plane.portrait.equilibria if one.span]
    lines += [PlaneLines("at rest", spans, at_end=None)] if spans else []
    lines += [PlaneLines("orbits", roles["orbit"], "orbit")] if roles["orbit"] else []
    return of_phase_plane((symbol(plane.name), symbol(plane.name + "'")), (of, f"{of}/s" if of else ""), plane.frame.q,
                          plane.frame.v[1], lines, _points(plane.portrait.equilibria),
                          plane.title)


def _points(equilibria: Iterable[Any]) -> list[list[tuple[float, str]]]:
    """[(names, places)] of each marker."""
    groups = {word: [] for word in MARKERS}
    for one in equilibria:
        group = groups[next((word for word in MARKERS[1:] if one.kind.endswith(word)), "")]
        group += [(one.q, one.kind)] if one.span is None else [(one.span[0], ""), (one.span[1], one.kind)]
    return list(groups.values())


def _found(problem: "Problem") -> dict[str, Any]:
    plane = problem.phase_plane
    energies = plane.portrait.energies or [None] * len(plane.portrait.equilibria)
    rows = [(one.q, one.span, one.kind, one.eigenvalues and list(one.eigenvalues), one.degenerate, energy)
            for one, energy in zip(plane.portrait.equilibria, energies, strict=True)]
    saddles = sorted(energy for one, energy in zip(plane.portrait.equilibria, energies, strict=True)
                     if plane.conservative and one.is_top)
    saddles = [b for a, b in pairwise([-inf, *saddles]) if b - a > SAME * b]
    own = plane.own
    start = own and (own.q, own.v, own.energy, own.turns, own.period and own.period[0], own.period and own.period[1],
                     own.end and own.end.q)
    return KEY.row(plane.name, plane.frame.q, plane.frame.v, plane.equilibria.search.complete,
                   [dict(zip([key.name for key in EQUILIBRIUM], row, strict=True)) for row in rows], saddles,
                   start and dict(zip([key.name for key in START], start, strict=True)))


EQUILIBRIUM = (
    Key("place", "the coordinate there; the middle of a line of rest"),
    Key("span", "[from, to] of a line of rest: places at each of which it rests; else null"),
    Key("kind", "centre, saddle, stable or unstable focus, node or degenerate node (of two equal eigenvalues), cusp, "
        "saddle-node, line of rest"),
    Key("eigenvalues", "[λ, λ] of the linearised motion [1/s], numbers or [re, im]; null where the forces bend"),
    Key("degenerate", "true where terms beyond the linear ones decide the kind, or the forces bend"),
    Key("energy", "V over that of the lowest equilibrium [J]; null where the forces have no potential"))
START = (
    Key("place", "the coordinate at t = 0"),
    Key("speed", "its rate at t = 0"),
    Key("energy", "½ m(q) q̇² + V at t = 0, over V of the lowest equilibrium [J]; null where there is none"),
    Key("turns", "[least, greatest] place of a closed orbit of a conservative scene, else null"),
    Key("period", "the period of it [s], else null"),
    Key("error", "bound of the relative error of the period"),
    Key("end", "the place of the equilibrium in which a damped motion is seen to end, else null"))
KEY = Key("phase_plane", "where --phase-plane asks for it: the phase plane of one degree of freedom", _found, of=(
    Key("coordinate", "its name"),
    Key("range", "[from, to]: the places that are shown"),
    Key("speeds", "[from, to]: the rates that are shown"),
    Key("complete", "true where it is proved that there are no other equilibria among these places"),
    Key("equilibria", "a list, in ascending order", each=EQUILIBRIUM),
    Key("separatrices", "energies of the separatrices of a conservative scene over V of the lowest equilibrium [J], "
        "ascending"),
    Key("start", "of the motion from `initial`; null where the file gives none", of=START)))
