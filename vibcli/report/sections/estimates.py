"""Estimates of the lowest natural frequency, by Rayleigh and by Dunkerley."""

from collections.abc import Iterable, Iterator, Sequence
from math import tau
from typing import TYPE_CHECKING, Any

from vibcli.base.errors import PhysicsError
from vibcli.notation.numbers import figure
from vibcli.report.blocks import Heading, Name, Section, TableBlock, maths, paragraph, section, separated
from vibcli.report.keys import Key
from vibcli.report.sections.insight import ROWS, off, require_numbers

if TYPE_CHECKING:
    from vibcli.report.document import Report
    from vibcli.results.problem import Problem


def estimates(problem: "Problem", _: "Report") -> Iterator[Section]:
    require_numbers(problem, "estimates")
    title = "Estimates of the lowest natural frequency"
    try:
        found = problem.modal.result("estimates")
    except PhysicsError as error:
        rigid, *beside = _of_what_is_free(problem)
        yield from section(title, paragraph(f"Not told: {error.message}."), *_elements(*beside, rigid))
        return
    rows = [(name, figure(omega), figure(omega / tau), "" if omega is found.omega else off(omega, found.omega))
            for name, omega in (("Rayleigh (from above)", found.rayleigh), ("exact", found.omega),
                                ("Dunkerley (from below)", found.dunkerley))]
    deflection = [maths(Name(name), " = ", figure(x, digits=4)) for name, x in list(found.deflection.items())[:ROWS]]
    alone = [f"{name}: {figure(x)} rad/s" for name, x in list(found.alone.items())[:ROWS]]
    yield from section(
        title, TableBlock(("", "ω [rad/s]", "f [Hz]", "error"), tuple(rows)),
        paragraph("Rayleigh's shape is the static deflection ", *separated(deflection, ",  "))
        if len(found.deflection) > 1 else None,
        paragraph("Dunkerley: ", maths("1/ω² = Σ 1/ω_j²"), ", with the inertia of one alone ", ",  ".join(alone))
        if len(found.alone) > 1 else None, *_members(found))


def _members(found: Any) -> Iterator[Any]:
    """Lumped equivalents and finite elements."""
    if found.members is None:
        return
    lumped = [(name, figure(one.mass), "" if one.of_members is None else figure(one.of_members), figure(one.stiffness),
               figure(one.omega), off(one.omega, found.omega))
              for name, one in list(found.members.lumped.items())[:ROWS]]
    if lumped:
        yield Heading("One coordinate alone, the rest as at rest (SI units):")
        yield TableBlock(("", "mass", "of the member's", "stiffness", "ω [rad/s]", "error"), tuple(lumped))
    yield from _elements(found.members.elements, found.members.exact)


def _elements(elements: Iterable[Any], exact: list[Any], rigid: int = 0) -> Iterator[Any]:
    """What finite elements give for frequencies beyond the rigid ones."""
    from vibcli.notation.names import lowered

    rows = [(str(divisions), *_beside(omegas, exact)) for divisions, omegas in elements]
    if rows:
        yield Heading("Finite elements (cubic of beams, linear of others):")
        heads = [head for i in range(1, len(exact) + 1) for head in (f"ω{lowered(rigid + i)} [rad/s]", "error")]
        yield TableBlock(("elements a piece", *heads), tuple(rows))


def _of_what_is_free(problem: "Problem") -> Any:
    """(rigid modes, [(elements a piece, [ω])], the exact ω) of members that are held nowhere; nothing of others."""
    modal = problem.modal
    linear = modal.configuration.linear_system
    if not any(placed.piece.inertia for placed in linear.pieces) or any(linear.G.values()) or not modal.modes[0].rigid:
        return 0, [], []
    from vibcli.analyses.continuous.member_estimates import beside_elements

    rigid = sum(mode.rigid for mode in modal.modes.shown())
    return rigid, *beside_elements(modal, rigid)


def _beside(omegas: Sequence[float], exact: Sequence[float]) -> Iterator[str]:
    """ω and its error, for each of the exact ones; nothing where there are fewer."""
    for i, omega in enumerate(exact):
        yield from (figure(omegas[i]), off(omegas[i], omega)) if i < len(omegas) else ("", "")


def _estimates(problem: "Problem") -> dict[str, Any]:
    try:
        found = problem.modal.result("estimates")
    except PhysicsError as error:
        return KEY.row(*[None] * 6, _by_divisions(_of_what_is_free(problem)[1]) or None, error.message)
    lumped = found.members and {name: one._asdict() for name, one in found.members.lumped.items()}
    elements = found.members and _by_divisions(found.members.elements)
    return KEY.row(found.omega, found.rayleigh, found.dunkerley, found.deflection, found.alone, lumped, elements, None)


def _by_divisions(elements: Iterable[tuple[int, Any]]) -> dict[str, Any]:
    return {str(divisions): omegas for divisions, omegas in elements}


KEY = Key("estimates", "of the lowest natural frequency; null where the bounds do not hold", _estimates, of=(
    Key("omega", "its exact value"),
    Key("rayleigh", "Rayleigh's quotient of the static deflection, an upper bound of omega"),
    Key("dunkerley", "Dunkerley's lower bound of omega"),
    Key("deflection", "{coordinate: static deflection}, the largest being 1"),
    Key("alone", "{name of a body: omega with its inertia alone}, from which Dunkerley's bound is made"),
    Key("lumped", "{coordinate: {mass, of_members, stiffness, omega}} of one coordinate that moves alone, the rest as "
        "at rest; of_members: the part of the one member's inertia in it; null without members"),
    Key("elements", "{elements a piece: [omega]} by finite elements, rigid modes left out; null without members"),
    Key("refusal", "why the bounds do not hold, or null")))
