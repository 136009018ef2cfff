"""The period of a motion by the expanded equations beside that of the full ones."""

from collections.abc import Iterator
from typing import TYPE_CHECKING, Any

from vibcli.base.errors import PhysicsError
from vibcli.notation.numbers import figure
from vibcli.report.blocks import Section, TableBlock, paragraph, section
from vibcli.report.keys import Key
from vibcli.symbolic.syntax import NameRef

if TYPE_CHECKING:
    from vibcli.results.expanded_response import ExpandedResponse
    from vibcli.results.problem import Problem


def periods(problem: "Problem", motion: "ExpandedResponse") -> Iterator[Section]:
    """Of one conservative degree of freedom."""
    found = compared_periods(problem, motion)
    if found is None:
        return
    title = f"Period of {found['coordinate']}"
    if found["reason"] is not None:
        yield from section(title, paragraph(f"{found['reason']}.", hang=0))
        return
    T, difference = found["full"], found["difference"]
    yield from section(title, TableBlock(("equations", "T [s]"), (
        ("to the third order", figure(found["expanded"])), ("in full", figure(T)),
        ("difference", f"{figure(difference)}   ({figure(100 * difference / T)} %)"))))


def compared_periods(problem: "Problem", motion: "ExpandedResponse") -> dict[str, Any] | None:
    """The same as data; None of several degrees, of motions that are driven or damped, and of other equations."""
    if not problem.spec.expanded or len(problem.scene.coordinates) != 1:
        return None
    name, = problem.scene.coordinates
    tree = NameRef(0, 0, name, 0)
    try:
        expanded, exact = motion.by_quadrature(tree), motion.full.by_quadrature(tree)
    except PhysicsError as refusal:
        return PERIODS.row(name, None, None, None, refusal.message)
    if expanded is None or exact is None:
        return None
    (T3, _), (T, _) = expanded, exact
    return PERIODS.row(name, T3, T, T3 - T, None)


PERIODS = Key("periods", "with motion: {order: 3}, of one degree without dampers and loads in time: its period by "
              "these equations beside that by the full ones; else null", of=(
    Key("coordinate", "the coordinate"),
    Key("expanded", "period by the equations to the third order, in s"),
    Key("full", "period by the full equations, in s"),
    Key("difference", "the former less the latter, in s"),
    Key("reason", "why there is no such period, in words, else null")))
