"""The period of a motion by the expanded equations beside that of the full ones."""

from collections.abc import Iterator
from typing import TYPE_CHECKING

from vibcli.base.errors import PhysicsError
from vibcli.notation.numbers import figure
from vibcli.report.blocks import Section, TableBlock, paragraph, section
from vibcli.symbolic.syntax import NameRef

if TYPE_CHECKING:
    from vibcli.results.expanded_response import ExpandedResponse
    from vibcli.results.problem import Problem


def periods(problem: "Problem", motion: "ExpandedResponse") -> Iterator[Section]:
    """Of one conservative degree of freedom."""
    if len(problem.scene.coordinates) != 1:
        return
    name, = problem.scene.coordinates
    tree = NameRef(0, 0, name, 0)
    title = f"Period of {name}"
    try:
        expanded = motion.by_quadrature(tree)
        exact = motion.full.by_quadrature(tree)
    except PhysicsError as refusal:
        yield from section(title, paragraph(f"{refusal.message}.", hang=0))
        return
    if expanded is None or exact is None:
        return
    (T3, _), (T, _) = expanded, exact
    yield from section(title, TableBlock(("equations", "T [s]"), (
        ("to the third order", figure(T3)), ("in full", figure(T)),
        ("difference", f"{figure(T3 - T)}   ({figure(100 * (T3 - T) / T)} %)"))))
