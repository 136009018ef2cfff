"""The energies of a scene by powers of the deviations from equilibrium, and the equations of motion so truncated."""

import math
from collections.abc import Callable, Iterator, Mapping, Sequence
from typing import TYPE_CHECKING, Any

from vibcli.base.errors import PhysicsError
from vibcli.notation.numbers import figure
from vibcli.report import blocks
from vibcli.report.blocks import Heading, Name, Section, line, paragraph, section
from vibcli.report.keys import Key
from vibcli.report.sections.equations_of_motion import numeric_sum
from vibcli.symbolic.normal_form import textbook

if TYPE_CHECKING:
    from vibcli.report.blocks import Line, Paragraph
    from vibcli.report.document import Report
    from vibcli.results.expansions import Expansion
    from vibcli.results.problem import Problem

WORD, ORDER = "expansion", 4
SHARES = {"material": "Energy of springs by their material (deflections of the first order alone)",
          "geometric": "Energy of springs by their geometry (the rest)"}
ENERGIES = {"V": "Potential energy", "T": "Kinetic energy"}


def order_asked(problem: "Problem") -> int:
    """The order of the energies."""
    find = problem.spec.get("find")
    record = find.about(WORD) if find is not None else None
    return ORDER if record is None else record.get("order", ORDER)


def expansion(problem: "Problem", _: "Report") -> Iterator[Section]:
    from vibcli.results.expansions import expansions

    order = order_asked(problem)
    found = expansions(problem, order)
    counted = "" if problem.symbolic.balanced_as_drawn else ", the coordinates counted from it"
    lines, several = [], len(found) > 1
    for one in found:
        lines.append((Heading("in numbers (SI units):") if several and not one.letters else None, one))
    yield from section(f"Deflections of springs, to order {order - 1} about the equilibrium{counted}",
                       *_each(lines, lambda one: _deflections(problem, one)),
                       *_series(problem, order - 1))
    if any(one.geometric for one in found[-1].springs.values()):
        for which, title in SHARES.items():
            yield from section(f"{title}, to order {order}", *_each(lines, lambda one, which=which: _shares(
                problem, one, which)))
    for which, title in ENERGIES.items():
        yield from section(f"{title}, to order {order} about the equilibrium{counted}",
                           *_each(lines, lambda one, which=which: [line(f"{which} = ", *sum_of(
                               problem, one, one.energies[which]))]))
    yield from section(f"Equations of motion, to order {order - 1} about the equilibrium{counted}",
                       *_each(lines, lambda one: _equations(problem, one)), _left_out(problem, found[0]))


def _series(problem: "Problem", order: int) -> "Iterator[Paragraph]":
    """How far the series of forces are off where the motion starts."""
    from vibcli.results.truncated_forces import truncated_forces

    for one in truncated_forces(problem, order):
        length, force = ("rad", "N·m") if "torsion" in problem.spec.get("springs")[one.spring] else ("m", "N")
        off = one.series / one.force - 1 if one.force else math.inf
        gives = f"its series to d^{order} gives {figure(one.series)} {force}"
        yield paragraph(f"Where the motion starts {one.spring} is deflected by {figure(one.deflection)} {length}: its "
                        f"force is {figure(one.force)} {force}, {gives} "
                        f"({100 * abs(off):.2g} % too {'much' if off > 0 else 'little'}).", hang=0)


def _each(lines: "Sequence[tuple[Heading, Expansion]]", told: "Callable[..., list[Line]]") -> Iterator[Any]:
    for heading, one in lines:
        shown = told(one)
        if shown:
            yield heading
            yield blocks.equations(shown)


def _deflections(problem: "Problem", one: "Expansion") -> "list[Line]":
    return [line(*sum_of(problem, one, terms), label=Name(name)) for name, terms in one.deflections.items() if terms]


def _shares(problem: "Problem", one: "Expansion", which: str) -> "list[Line]":
    return [line("V = ", *sum_of(problem, one, getattr(shares, which)), label=Name(name))
            for name, shares in one.springs.items()]


def _equations(problem: "Problem", one: "Expansion") -> "list[Line]":
    return [line(*sum_of(problem, one, terms), " = 0", label=Name(name)) for name, terms in zip(
        problem.scene.coordinates, one.equations or (), strict=one.equations is not None)]


def sum_of(problem: "Problem", one: "Expansion", terms: Any) -> Sequence[Any]:
    """Parts of Σ factor·product."""
    table = problem.scene.table
    products = [(c, one.product(powers)) for powers, c in terms.items()]
    if not one.letters:
        return numeric_sum(products)
    return [table.sum(*((textbook(c * product), 1) for c, product in products))]


def left_out(problem: "Problem", one: "Expansion") -> list[str]:
    """What the equations do not hold."""
    left = ["dampers"] * any(problem.spec.get(name) for name in ("dampers", "damping"))
    return left + ["what changes with time"] * one.timed


def _left_out(problem: "Problem", one: "Expansion") -> "Paragraph | None":
    if one.equations is None:
        return paragraph("Not written out: loads follow the motion here. `motion: {order: 3}` follows the expanded "
                         "motion.", hang=0)
    left = left_out(problem, one)
    return paragraph(f"Left out: {' and '.join(left)}.", hang=0) if left else None


def _data(problem: "Problem") -> dict[str, Any]:
    """Of numbers where all parameters have values, with the letters beside them where they are known."""
    from vibcli.results.expansions import expansions
    from vibcli.results.truncated_forces import truncated_forces

    order = order_asked(problem)
    try:
        found = expansions(problem, order)
    except PhysicsError as refusal:
        return KEY.row(order, None, None, None, None, None, None, refusal.message)
    *_, one = found
    letters = found[0] if found[0].letters else None
    springs = [SPRINGS.row(name, *(_rows(one, get(one), letters and get(letters)) for get in (
        lambda each, name=name: each.deflections[name], lambda each, name=name: each.springs[name].material,
        lambda each, name=name: each.springs[name].geometric))) for name in one.springs]
    V, T = (_rows(one, one.energies[which], letters and letters.energies[which]) for which in "VT")
    equations = None if one.equations is None else [
        {"coordinate": name, "terms": _rows(one, one.equations[i], letters and letters.equations[i])}
        for i, name in enumerate(problem.scene.coordinates)]
    series = [SERIES.row(*row) for row in truncated_forces(problem, order - 1)]
    return KEY.row(order, V, T, springs, series, equations, None if equations is None else left_out(problem, one), None)


def _rows(one: "Expansion", terms: Mapping[tuple[int, ...], Any],
          letters: Mapping[tuple[int, ...], Any] | None) -> list[dict[str, Any]]:
    """[{product, factor, letters}] of terms, as they are and in letters."""
    from vibcli.notation.scene_language import language

    return [{"product": language(one.product(powers)), "factor": language(c) if one.letters else float(c),
             "letters": language(letters[powers]) if letters and powers in letters else None}
            for powers, c in terms.items()]


_TERMS = (Key("product", "of deviations and their rates, in the language of scenes"),
          Key("factor", "what it has, a number where all parameters have values"),
          Key("letters", "the same as an expression; null where it is not known"))
SPRINGS = Key("springs", "a list, one entry to each spring", each=(
    Key("spring", "its name"),
    Key("stretch", "its deflection from the equilibrium, a list of terms", each=_TERMS),
    Key("material", "what it has of V by its material, were its deflection of the first order alone", each=_TERMS),
    Key("geometric", "what its geometry adds: the rest", each=_TERMS)))
SERIES = Key("series", "a list, one entry to each spring whose force is no polynomial, where the motion starts", each=(
    Key("spring", "its name"), Key("deflection", "there"), Key("force", "there"),
    Key("series", "what its series about zero deflection gives there, to one order less than the energies")))
KEY = Key(WORD, "the energies by powers of the deviations from equilibrium", _data, of=(
    Key("order", "of the energies"),
    Key("V", "potential energy, a list of terms", each=_TERMS),
    Key("T", "kinetic energy, a list of terms", each=_TERMS),
    SPRINGS,
    SERIES,
    Key("equations", "a list, one entry to each coordinate; null where loads follow the motion", each=(
        Key("coordinate", "the coordinate"), Key("terms", "of its left side, whose sum is 0", each=_TERMS))),
    Key("left_out", "a list of what the equations do not hold, in words; null where there are none"),
    Key("reason", "why there is no expansion, in words, else null")))
