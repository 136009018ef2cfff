"""The steps of members of a scene whose equilibrium a search finds: where it rests, M and K of what is lumped about it,
and with the dynamic stiffness of each stretch det D(ω) = 0 (V. Koloušek, Dynamics in Engineering Structures, 1973)."""

from collections.abc import Iterator
from typing import TYPE_CHECKING

from vibcli.notation.names import lowered
from vibcli.report.blocks import Name, Words
from vibcli.report.steps.coordinates import tell_coordinates
from vibcli.report.steps.matrix_units import unit_of_entry
from vibcli.report.steps.member_steady import tell_end_forces
from vibcli.report.steps.step import WorkedSolution, number, of_time, told

if TYPE_CHECKING:
    import numpy as np

    from vibcli.mechanics.factored_system import PlacedPiece
    from vibcli.results.problem import Problem

STIFFNESS = {2: "S", 4: "B"}        # letter by order
FIRST = 3           # roots that are told
NOTHING = 1e-12     # relative: what rounding leaves of an entry


def tell_members_about_rest(problem: "Problem", sheet: WorkedSolution) -> None:
    """Write down all of them."""
    tell_coordinates(problem, problem.scene, sheet)
    rest, system = problem.configuration.equilibrium, problem.configuration.linear_system
    places = [part for name in problem.scene.coordinates for part in (
        Words(",  "), Name(name), *number(rest.values[name], "m" if problem.system.dimension(name) else "rad"))]
    line = sheet.write(Words("the forces balance at  "), *places[1:], Words("   (by a search)"), settles="equilibrium")
    letters = sheet.letter("D"), sheet.letter("U"), sheet.matrix("K"), sheet.matrix("M")
    D, U, K, M = map(Name, letters)
    line = sheet.write(Words("small oscillations about it:  "), D, "·", U, " = 0", Words(",  "), D, " = ", K,
                       " − ω²·", M, Words(",  of what is lumped, and of the dynamic stiffness of each stretch"),
                       settles="dynamic stiffness", uses=[line])
    lumped = system.with_parts(pieces=()).arrays()
    entries = [part for letter, which, matrix in ((letters[3], "M", lumped[0]), (letters[2], "K", lumped[3]))
               for part in _entries(problem, letter, which, matrix)]
    names = [part for name in problem.scene.coordinates for part in (Words(", "), Name(name))][1:]
    lines = [sheet.write(Words("of  "), *names, Words(":  "), *entries[1:], settles="what is lumped", uses=[line])]
    kinds = {(placed.owner, placed.piece.order, float(placed.piece.inertia), float(
        placed.piece.bending or placed.piece.tension)): placed for placed in system.pieces}
    orders: set[int] = set()
    for one in kinds.values():
        if not (one.piece.gradient or one.piece.foundation or (one.piece.bending and one.piece.tension)):
            several = sum(owner == one.owner for owner, *_ in kinds) > 1
            where = f", {told(float(one.start))} m < x < {told(float(one.start + one.piece.length))} m" * several
            lines.append(_stretch(problem, sheet, one, where, line))
            orders.add(one.piece.order)
    lines += [tell_end_forces(sheet, order, line, STIFFNESS[order]) for order in sorted(orders)]
    line = sheet.write("det ", D, " = 0", Words("  by a search, which misses none"), settles="frequencies", uses=lines)
    for mode in problem.modal.modes.first(FIRST):
        if mode.omega:
            omega = float(mode.omega)
            sheet.write(f"ω{lowered(mode.index)}", *number(omega, "rad/s"), *of_time(sheet, omega),
                        settles=f"omega[{mode.index}]", value=omega, unit="rad/s", uses=[line])


def _stretch(problem: "Problem", sheet: WorkedSolution, placed: "PlacedPiece", which: str, line: int) -> int:
    """The line of β of a uniform stretch."""
    piece, turns = placed.piece, problem.scene.members[placed.owner].kind.letter == "phi"
    stiff, power = STIFFNESS[piece.order], "⁴" if piece.bending else "²"
    unit = "N·m²" if piece.bending or turns else "N"
    return sheet.write(Words(f"{placed.owner}{which}:  "), f"β{power} = μ·ω²/{stiff}", Words(",  "), "μ", *number(
        float(piece.inertia), "kg·m" if turns else "kg/m"), Words(",  "), stiff, *number(
            float(piece.bending or piece.tension), unit), settles=f"beta {placed.owner}{which}", uses=[line])


def _entries(problem: "Problem", name: str, which: str, matrix: "np.ndarray") -> Iterator[Name | str | Words]:
    """Parts of the entries on the diagonal and above that are not zero, a comma before each."""
    least = NOTHING * abs(matrix).max()
    for i in range(len(matrix)):
        for j in range(i, len(matrix)):
            if abs(matrix[i, j]) > least:
                yield from (Words(",  "), Name(f"{name}{i + 1}{j + 1}"), *number(
                    float(matrix[i, j]), unit_of_entry(problem, i, j, which)))
