"""The system about one equilibrium of a list, degenerate ones included.

Where K is singular at an equilibrium that was searched for — a multiple zero of the forces, a line of equilibria —
Newton's method gives no more digits than floats have. The stiffness then counts as known to BLUR of what is typical of
the scene, and what is below that as zero.
"""

from contextlib import suppress
from math import sqrt

from vibcli.base.errors import PhysicsError
from vibcli.mechanics.equilibrium.equilibrium import EnergyDescent, Equilibrium, relative_residual
from vibcli.mechanics.equilibrium.zero_modes import FREE
from vibcli.mechanics.factored_system import OscillatorElements
from vibcli.mechanics.high_precision import GUARD, NOTHING, ROUNDED, Degenerate, equilibrium_to
from vibcli.mechanics.numeric_linearisation import in_numbers
from vibcli.symbolic.evaluation import Floats, multiprecision

BLUR, ALONG = 1e-6, 1e-9           # at a multiple zero; on a line of equilibria
UNSETTLED, NEAR = 1e-9, 0.1        # of the figure: a step that is no rounding; how far a place may move
TINY = 1e-5                        # of the figure: a displacement of which floats may know less than is printed
LIMIT = 1e-9                       # at a limit of stability, which is solved for with its null vector
UNIT = 2.0**53


def about(problem, item):
    """The Problem about the equilibrium of an Item (mechanics/equilibria.py)."""
    found = problem.at_equilibrium(item.equilibrium)
    with suppress(PhysicsError):    # it is raised again where the modes are asked for
        if not (item.equilibrium.drawn or problem.is_linear):
            _settle(found, item, problem.equilibria.forces)
        rigid = [mode.index for mode in found.modes if mode.rigid] if item.free else ()
        if item.free and len(rigid) == len(item.free):
            found.zero_modes = dict.fromkeys(rigid, FREE)
    return found


def settled_alone(problem, position):
    """The elements of a Problem whose equilibrium is degenerate, in floats; `position`: a better one, or None."""
    if position is not None and problem.scene.loops is None:
        problem.equilibrium.values = {name: float(value) for name, value in position.items()}
    from vibcli.mechanics.equilibrium.families import freedom, learnt

    forces = learnt(problem)
    _blur(problem, forces, ALONG if freedom(problem, forces) else BLUR)
    return problem.elements


def sharpened(problem, found):
    """The Equilibrium `found`, its place refined where Newton's method would still move it: near a multiple zero the
    forces are rounding long before the place is known. So is a displacement that is tiny beside the figure, the
    difference of lengths of which floats know few digits."""
    search = EnergyDescent(problem, found.values)
    vector = search.vector(found.values)
    tiny = any(0 < x < TINY for x in abs(vector / search.scale))
    with suppress(PhysicsError):
        settled = max(abs(search.newton(search.at(vector))), default=0.0) <= UNSETTLED
        if settled and not tiny:
            return found
        position, degenerate = _to_more_digits(problem.at_equilibrium(found))
        found.degenerate = degenerate and not settled
        if position is not None and max(abs((search.vector(position) - vector) / search.scale)) <= NEAR:
            found.values = {name: _but_for_nothing(problem, name, value) for name, value in position.items()}
    return found


def _but_for_nothing(problem, name, value):
    """A coordinate as a float, 0 where it is nothing beside the figure."""
    unit = (problem.figure_size or 1.0) if problem.dimension(name) else 1.0
    return float(value) if abs(value) > NOTHING * unit else 0.0


def _to_more_digits(problem):
    """({coordinate: number} of the equilibrium or None where nothing better is known, is it degenerate?)."""
    import mpmath

    with mpmath.workdps(ROUNDED + GUARD):
        arithmetic = multiprecision()
        try:
            return equilibrium_to(problem, problem.values(arithmetic), arithmetic), False
        except Degenerate as degenerate:
            return degenerate.position, True


def at_limit(problem, position, felt):
    """The Problem in an equilibrium ({coordinate: float}) whose K is singular but for rounding; felt: what counts as
    stiff along each coordinate."""
    found = problem.sharing({})
    numbers = in_numbers(found.form, Floats, {**found.floats, found.scene.time.name: 0.0, **position})
    found.equilibrium = Equilibrium(position, False, relative_residual(numbers))
    sizes = {(i, j): sqrt(a * b) for i, a in enumerate(felt) for j, b in enumerate(felt)}
    elements = _known_to(numbers.elements, {pair: UNIT * LIMIT * size for pair, size in sizes.items()})
    elements.K = {pair: x for pair, x in elements.K.items() if abs(x) > LIMIT * sizes[pair]}
    found.elements, found.sources = elements, (None, None)
    return found


def _settle(found, item, forces):
    """Give the Problem elements in floats where its equilibrium has no more digits."""
    if any(name in forces.names for direction in item.free for name in direction):
        _blur(found, forces, ALONG)
        return
    try:
        found.elements  # noqa: B018
    except PhysicsError:
        if not item.singular:
            raise
        _blur(found, forces, BLUR)


def _blur(found, forces, blur):
    exact = in_numbers(found.form, Floats, {**found.floats, **found.equilibrium.values}).elements
    felt = dict(zip(forces.rows, forces.D, strict=True))
    size = {(i, j): UNIT * blur * forces.E / (a * b) for i, a in felt.items() for j, b in felt.items()}
    found.elements, found.sources = _known_to(exact, size), (None, None)


def _known_to(exact, size):
    """Elements whose stiffness counts as known to 2⁻⁵³ of `size`."""
    return OscillatorElements(exact.n, exact.inertias, (), exact.dampers, M=exact.M, C=exact.C, G=exact.G,
                              drag=exact.drag, K=exact.stiffness(), K_size=size, massless=exact.massless)
