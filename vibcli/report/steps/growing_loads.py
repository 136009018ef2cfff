"""The steps to what follows loads that are powers of the time."""

from vibcli.base.errors import PhysicsError
from vibcli.report.blocks import Name, Words
from vibcli.report.steps.held import SmallEquations
from vibcli.report.steps.small import AboutRest
from vibcli.report.steps.step import WorkedSolution


def tell_growing(about: AboutRest, sheet: WorkedSolution, found: SmallEquations) -> None:
    """What each coordinate follows loads that are powers of the time by."""
    for name in about.scene.coordinates:
        try:
            node = about.problem.symbolic_following(name)
        except PhysicsError:
            return
        sheet.write(Words("tried in the equations, the form of the load gives  "), Name(name), " = ", node,
                    settles=f"following({name})", node=node, uses=found.lines)
