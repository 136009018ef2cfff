"""The energies of a scene by powers of the deviations from equilibrium, and the equations of motion so truncated."""

from collections.abc import Iterator
from typing import TYPE_CHECKING

from vibcli.base.errors import PhysicsError
from vibcli.report import blocks
from vibcli.report.blocks import Heading, Name, Section, line, paragraph, section
from vibcli.report.keys import Key
from vibcli.report.sections.equations_of_motion import numeric_sum

if TYPE_CHECKING:
    from vibcli.report.document import Report
    from vibcli.results.expansions import Expansion
    from vibcli.results.problem import Problem

WORD, ORDER = "expansion", 4
ENERGIES = {"V": "Potential energy", "T": "Kinetic energy"}


def _order(problem):
    find = problem.spec.get("find")
    record = find.about(WORD) if find is not None else None
    return ORDER if record is None else record.get("order", ORDER)


def expansion(problem: "Problem", _: "Report") -> Iterator[Section]:
    from vibcli.results.expansions import expansions

    order = _order(problem)
    found = expansions(problem, order)
    counted = "" if problem.symbolic.balanced_as_drawn else ", the coordinates counted from it"
    lines, several = [], len(found) > 1
    for one in found:
        lines.append((Heading("in numbers (SI units):") if several and not one.letters else None, one))
    yield from section(f"Deflections of springs, to order {order - 1} about the equilibrium{counted}",
                       *_each(lines, lambda one: _deflections(problem, one)))
    for which, title in ENERGIES.items():
        yield from section(f"{title}, to order {order} about the equilibrium{counted}",
                           *_each(lines, lambda one, which=which: [line(f"{which} = ", *_sum(
                               problem, one, one.energies[which]))]))
    yield from section(f"Equations of motion, to order {order - 1} about the equilibrium{counted}",
                       *_each(lines, lambda one: _equations(problem, one)), _left_out(problem, found[0]))


def _each(lines, told):
    for heading, one in lines:
        shown = told(one)
        if shown:
            yield heading
            yield blocks.equations(shown)


def _deflections(problem, one):
    return [line(*_sum(problem, one, terms), label=Name(name)) for name, terms in one.deflections.items() if terms]


def _equations(problem, one: "Expansion"):
    return [line(*_sum(problem, one, terms), " = 0", label=Name(name)) for name, terms in zip(
        problem.scene.coordinates, one.equations or (), strict=one.equations is not None)]


def _sum(problem, one: "Expansion", terms):
    """Parts of Σ factor·product."""
    table = problem.scene.table
    products = [(c, one.product(powers)) for powers, c in terms.items()]
    if not one.letters:
        return numeric_sum(products)
    return [table.sum(*((c * product, 1) for c, product in products))]


def _left_out(problem, one: "Expansion"):
    if one.equations is None:
        return paragraph("Not written out: loads follow the motion here. `motion: {order: 3}` follows the expanded "
                         "motion.", hang=0)
    left = ["dampers"] * any(problem.spec.get(name) for name in ("dampers", "damping"))
    left += ["what changes with time"] * one.timed
    return paragraph(f"Left out: {' and '.join(left)}.", hang=0) if left else None


def _data(problem):
    """Of numbers alone, else of letters."""
    from vibcli.notation.scene_language import language
    from vibcli.results.expansions import expansions

    order = _order(problem)
    try:
        *_, one = expansions(problem, order)
    except PhysicsError:
        return None
    write = language if one.letters else float

    def rows(terms):
        return [{"product": language(one.product(powers)), "factor": write(c)} for powers, c in terms.items()]

    return KEY.row(order, rows(one.energies["V"]), rows(one.energies["T"]),
                   None if one.equations is None else [
                       {"coordinate": name, "terms": rows(terms)}
                       for name, terms in zip(problem.scene.coordinates, one.equations, strict=True)])


_TERMS = (Key("product", "of deviations and their rates, in the language of scenes"), Key("factor", "what it has"))
KEY = Key(WORD, "the energies by powers of the deviations from equilibrium; null where there are none", _data, of=(
    Key("order", "of the energies"),
    Key("V", "potential energy, a list of terms", each=_TERMS),
    Key("T", "kinetic energy, a list of terms", each=_TERMS),
    Key("equations", "a list, one entry to each coordinate; null where loads follow the motion", each=(
        Key("coordinate", "the coordinate"), Key("terms", "of its left side, whose sum is 0", each=_TERMS)))))
