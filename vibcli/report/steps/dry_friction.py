"""The steps of a mass on a spring that dry friction brings to rest: with the force R against its way,

    m q̈ + k q − F ± R = 0:   half cycles of π/ω about (F ∓ R)/k, each 2R/k shorter than the one before,

until it turns where |k q − F| ≤ R₀, what friction resists with at rest (Rao 2011, section 2.9)."""

from math import isclose, pi, sqrt
from typing import TYPE_CHECKING

from vibcli.base.errors import PhysicsError
from vibcli.base.named_tuple import NamedTuple
from vibcli.report.blocks import Factor, Name, Words
from vibcli.report.steps.held import HINT, UNTOLD, Untold
from vibcli.report.steps.in_motion import short_form
from vibcli.report.steps.step import WorkedSolution, number, told
from vibcli.symbolic.derivatives import gradient, substitute
from vibcli.symbolic.evaluation import Floats, evaluate
from vibcli.symbolic.expression_graph import reachable
from vibcli.symbolic.normal_form import is_zero, textbook

if TYPE_CHECKING:
    from collections.abc import Sequence

    from vibcli.results.problem import Problem
    from vibcli.symbolic.node import Node

MOST = 12           # half cycles that are told
CLOSE = 1e-9        # relative: of a place or an instant by the lines and the engine's


class Coulomb(NamedTuple):
    """m, k, F and R of m q̈ + k q + R sign q̇ = F, and R₀."""

    m: "Node"
    k: "Node"
    F: "Node"
    R: "Node"
    R0: "Node"


def tell_friction(problem: "Problem", sheet: WorkedSolution, lines: "Sequence[int]") -> None:
    """Write down the half cycles of a motion that the scene starts at rest; nothing of what is no such mass."""
    if problem.spec.get("initial") is None or problem.numeric.has_free_symbols or len(problem.scene.q) != 1:
        return
    before = len(sheet.steps)
    try:
        found, (place,), (speed,) = coulomb(problem), *(values.values() for values in problem.initial.start)
        if found is not None and not speed:
            _write(problem, sheet, found, place, lines)
    except PhysicsError:
        del sheet.steps[before:]


def coulomb(problem: "Problem") -> Coulomb | None:
    """The Coulomb of a scene of one coordinate; None of others."""
    equations, held, scene = problem.symbolic.equations.full, problem.system.sticking, problem.scene
    if len(equations) != 1 or held is None or len(held.rows) != 1 or held.rows[0].within is None:
        return None
    q, v, a = scene.q[0], scene.v[0], scene.a[0]
    senses = [node for node in reachable(equations) if node.op == "call" and node.name == "sign"]
    if len(senses) != 1 or not is_zero(senses[0].args[0] - v):
        return None
    zero = scene.table.zero
    ahead, free = (textbook(substitute([equations[0]], {senses[0]: value})[0]) for value in (scene.table.one, zero))
    m, k = (gradient(free).get(symbol, zero) for symbol in (a, q))
    R, F = ahead - free, -substitute([free], dict.fromkeys((q, v, a), zero))[0]
    whole = is_zero(free - (m * a + k * q - F)) and is_zero(equations[0] - (free + R * senses[0]))
    if not whole or any(part.mask for part in (m, k, R, F)) or k.is_zero:
        return None
    return Coulomb(*map(short_form, (m, k, F, R, held.rows[0].within)))


def _write(problem: "Problem", sheet: WorkedSolution, found: Coulomb, place: float, lines: "Sequence[int]") -> None:
    floats = problem.numeric.floats
    m, k, F, R, R0 = evaluate(list(found), Floats, floats)
    name, unit = Name(problem.scene.coordinates[0]), "m" if problem.system.dimension(
        problem.scene.coordinates[0]) else "rad"
    if not min(m, k, R) > 0:
        return
    about = [(found.F + sign * found.R) / found.k for sign in (-1, 1)]
    values = evaluate(about, Floats, floats)
    line = sheet.write(Words("while "), Name(name.text + "'"), " > 0", Words(" it swings about  "), about[0], *number(
        values[0], unit), Words(",  while "), Name(name.text + "'"), " < 0", Words(" about  "), about[1], *number(
            values[1], unit), settles="centres of half cycles", uses=lines)
    omega = problem.scene.table.sqrt(found.k / found.m)
    half = pi * sqrt(m / k)
    omega_line = sheet.write(Name(sheet.letter("omega")), " = ", omega, *number(sqrt(k / m), "rad/s"), Words(
        ",  a half cycle takes  "), "π/", Name(sheet.letter("omega")), *number(half, "s"), settles="half cycle",
        value=half, unit="s", node=problem.scene.table.pi / omega, uses=[line])
    shorter = sheet.write(Words("each is shorter than the one before by  "), 2 * found.R / found.k, *number(
        2 * R / k, unit), settles="loss of a half cycle", node=2 * found.R / found.k, value=2 * R / k, unit=unit,
        uses=[line])
    force = [Factor(found.k), "·", name, *([] if is_zero(found.F) else [" − ", Factor(found.F)])]
    stuck = sheet.write(Words("it stays where it turns within  |"), *force, Words("| ≤ "), found.R0, *number(
        R0, "N" if unit == "m" else "N·m"), settles="sticks", uses=lines)
    turns = [place]
    while abs(k * turns[-1] - F) > R0 and len(turns) <= MOST:
        turns.append(2 * (F + R if k * turns[-1] > F else F - R) / k - turns[-1])
    _hold(problem, turns, half)
    cycles = len(turns) - 1
    if not cycles:
        sheet.write(Words("so it stays where it starts,  "), name, *number(place, unit), settles=f"final({name.text})",
                    value=place, unit=unit, uses=[stuck])
        return
    text = ", ".join(told(value) for value in turns[1:])
    sheet.write(Words("from  "), name, *number(place, unit), Words("  it goes to  "), text, Words(
        f" {unit},  where it rests after {cycles} half cycle{'s' * (cycles != 1)},  "), Name(problem.scene.time.name),
        *number(cycles * half, "s"), settles=f"final({name.text})", value=turns[-1], unit=unit,
        uses=[omega_line, shorter, stuck])


def _hold(problem: "Problem", turns: "Sequence[float]", half: float) -> None:
    """Untold where the engine does not come to rest there and then."""
    end = (len(turns) - 1) * half
    known = problem.scene.coordinates[0]
    motion = problem.response
    signal = motion.signal_of(problem.scene.symbol(known, 0), {})
    found = signal.values([end, 1.5 * end + half])
    size = max(map(abs, turns))
    if len(turns) > MOST or not all(isclose(float(x), turns[-1], rel_tol=CLOSE, abs_tol=CLOSE * size) for x in found):
        raise Untold(UNTOLD, HINT)
