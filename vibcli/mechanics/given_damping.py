"""What `damping:` adds to the dampers of the small oscillations, M φᵢ = rᵢ, φᵢᵀ M φᵢ = 1, K φᵢ = ωᵢ² M φᵢ:

    modal          C = Σ 2 ζᵢ ωᵢ rᵢ rᵢᵀ        of those that vibrate
    caughey        C = Σ p(ωᵢ²) rᵢ rᵢᵀ         p(λ) = a₀ + a₁ λ + …, p(ωⱼ²) = 2 ζⱼ ωⱼ at the modes that are given
    proportional   C = α M + β K

found to many digits, so that its floats are correctly rounded. Driven supports u leave the modes at −K⁻¹ K_u u, from
which modal damping counts velocities: C_u = Σ (c/ω²) rᵢ φᵢᵀ K_u; that in proportion has C_u = α M_u + β K_u.
"""

from collections.abc import ValuesView
from itertools import pairwise
from typing import TYPE_CHECKING, Any

from vibcli.base.errors import PhysicsError
from vibcli.base.named_tuple import NamedTuple
from vibcli.mechanics.factored_system import FactoredSystem, summed
from vibcli.symbolic.evaluation import Floats, evaluate, multiprecision

if TYPE_CHECKING:
    from collections.abc import Mapping, Sequence

    import mpmath

    from vibcli.language.reader import Expression, Record
    from vibcli.mechanics.configuration import Configuration

DIGITS, LARGEST = 40, 40        # of what is rounded to floats; coordinates
NOTHING, ALIKE = 1e-25, 1e-12   # of the largest ω²: what is zero; relative: what is one frequency
ADVICE = "write `proportional: [alpha, beta]`, or the dampers one by one under dampers"


class RatedMode(NamedTuple):
    """A mode that is damped: c = 2 ζ ω, its ω², φ and r = M φ, lists by coordinate."""

    c: Any
    square: Any
    shape: list[Any]
    row: list[Any]


def damping_of(configuration: "Configuration", digits: int) -> FactoredSystem:
    """What `damping:` adds to the element data of a Configuration, to so many digits."""
    import mpmath

    from vibcli.mechanics.high_precision import GUARD, system_to

    with mpmath.workdps(digits + GUARD):
        elements = system_to(configuration, digits)
        return added(configuration.spec.get("damping"), given_numbers(configuration), elements)


def columns_of(configuration: "Configuration", M: "Mapping[tuple[int, int], float | mpmath.mpf]",
               K: "Mapping[tuple[int, int], float | mpmath.mpf]", n: int,
               driven: "Sequence[int]") -> "dict[tuple[int, int], Any]":
    """C_u {(i, j): number} of the displacements j that drive a scene of n coordinates, from its M and K with theirs."""
    if not driven:
        return {}
    import mpmath

    from vibcli.mechanics.high_precision import GUARD, system_to

    record = configuration.spec.get("damping")
    number = float if configuration.arithmetic is Floats else mpmath.mpf
    digits = max(DIGITS, mpmath.mp.dps)
    with mpmath.workdps(digits + GUARD):
        values = given_numbers(configuration)
        if "proportional" in record:
            alpha, beta = values["proportional"]
            pairs = [(i, j) for i in range(n) for j in driven if (i, j) in M or (i, j) in K]
            return {pair: number(alpha * M.get(pair, 0) + beta * K.get(pair, 0)) for pair in pairs}
        found = {}
        for mode in damped_modes(record, values, system_to(configuration, digits)):
            for j in driven:
                pull = mpmath.fsum(x * K[i, j] for i, x in enumerate(mode.shape) if (i, j) in K)
                share = mode.c / mode.square * pull if mode.square > 0 else 0
                for i, x in enumerate(mode.row):
                    found[i, j] = found.get((i, j), 0) + share * x
        return {pair: number(x) for pair, x in found.items() if x}


def given_numbers(configuration: "Configuration", arithmetic: Any = None) -> "dict[str, Any]":
    """{key: its numbers} of `damping:` in an arithmetic, else at the working precision of mpmath."""
    arithmetic = arithmetic or multiprecision()
    known, lower = configuration.numeric.values(arithmetic), configuration.scene.lower

    def numbers(expressions: "Sequence[Expression] | ValuesView[Any]") -> "list[float | mpmath.mpf]":
        return evaluate([lower(expression) for expression in expressions], arithmetic, known)

    record = configuration.spec.get("damping")
    return {key: dict(zip(given, numbers(given.values()), strict=True)) if isinstance(given, dict)
            else list(numbers(given)) for key, given in record.items()}


def coupled(record: "Record", elements: Any) -> bool:
    """Does damping in proportion stand beside what couples the modes of members with inertia? PhysicsError where
    `damping:` is not found; ratios of modes stand beside dampers at places alone."""
    if not any(placed.piece.inertia for placed in elements.pieces):
        raise PhysicsError("members with drag and without inertia are not damped as a whole",
                           "take `damping:` out, or give the members inertia")
    drag, turning = any(placed.piece.drag for placed in elements.pieces), any(elements.G.values())
    if "proportional" in record:
        return bool(drag or turning or elements.dampers or elements.C or elements.drag)
    if drag or turning or elements.drag:
        out = "" if turning or elements.drag else ", or take the drag out and give the modes higher ratios"
        raise PhysicsError("ratios of modes of members are found where no drag and no gyroscopic terms act besides",
                           "write `proportional: [alpha, beta]`" + out)
    return False


def as_a_whole(configuration: "Configuration", elements: FactoredSystem,
               moved: "Sequence[int] | None") -> FactoredSystem:
    """Element data of members with α M + β K beside what damps them: pieces have the drag α μ and the retardation β.
    moved: the coordinates that are displacements, where some are loads."""
    import mpmath

    from vibcli.mechanics.high_precision import GUARD

    exact = any(isinstance(placed.piece.length, mpmath.mpf) for placed in elements.pieces)
    with mpmath.workdps(max(DIGITS, mpmath.mp.dps if exact else 0) + GUARD):
        alpha, beta = given_numbers(configuration)["proportional"]
    alpha, beta = (+alpha, +beta) if exact else (float(alpha), float(beta))
    pieces = [placed._replace(retardation=beta, piece=placed.piece._replace(
        drag=placed.piece.drag + alpha * placed.piece.inertia)) for placed in elements.pieces]
    more = in_proportion(alpha, beta, elements)
    if moved is not None:
        more = more.with_parts(C={pair: x for pair, x in more.C.items() if {*pair} <= {*moved}})
    return with_damping(elements, more).with_parts(pieces=pieces)


def with_damping(elements: FactoredSystem, more: FactoredSystem) -> FactoredSystem:
    """Element data with what is added to their damping."""
    return elements.with_parts(dampers=elements.dampers + more.dampers, C=summed(elements.C, more.C))


def added(record: "Record", values: "Mapping[str, Any]", elements: Any) -> FactoredSystem:
    """The dampers and the C that are added to element data, in their numbers of mpmath, as element data."""
    if "proportional" in record:
        return in_proportion(*values["proportional"], elements)
    modes = damped_modes(record, values, elements)
    if len(values.get("caughey") or ()) == 2 and modes and not elements.massless and modes[-1].square > modes[0].square:
        alpha, beta = _through_both(modes[0], modes[-1])
        if alpha >= 0 and beta >= 0:        # without cancellation
            return in_proportion(alpha, beta, elements)
    return FactoredSystem(elements.n, dampers=[(mode.c, {i: x for i, x in enumerate(mode.row) if x}) for mode in modes])


def _through_both(one: RatedMode, two: RatedMode) -> "tuple[mpmath.mpf, mpmath.mpf]":
    """α, β of the series of two terms, c = α + β ω²: C has no entries but those of M and K."""
    beta = (two.c - one.c) / (two.square - one.square)
    return one.c - beta * one.square, beta


def in_proportion(alpha: Any, beta: Any, elements: Any) -> FactoredSystem:
    """α M + β K."""
    terms = [(factor * weight, row) for factor, rows in ((alpha, elements.inertias), (beta, elements.springs))
             for weight, row in rows if factor * weight]
    C = summed({pair: alpha * x for pair, x in elements.M.items()}, {pair: beta * x for pair, x in elements.K.items()})
    return FactoredSystem(elements.n, dampers=terms, C={pair: x for pair, x in C.items() if x})


def damped_modes(record: "Record", values: "Mapping[str, Any]", elements: Any) -> list[RatedMode]:
    """The modes that `modal` or `caughey` damps."""
    import mpmath

    _require_modes(elements)
    if len(elements.massless) == elements.n:        # without inertia there are no modes
        return []
    squares, shapes, rows = _modes(elements)
    ratios, rates = values.get("modal"), [mpmath.sqrt(x) if x > 0 else mpmath.mpf(0) for x in squares]
    if ratios is not None:
        each = [ratios[min(i, len(ratios) - 1)] for i in range(len(squares))]
        _require_one_ratio(squares, each)
        c = [2 * zeta * omega for zeta, omega in zip(each, rates, strict=True)]
    else:
        c = _of_series(values["caughey"], squares, rates)
    return [RatedMode(*one) for one in zip(c, squares, shapes, rows, strict=True) if one[0]]


def _require_modes(elements: FactoredSystem) -> None:
    if any(elements.G.values()) or elements.circulatory:
        raise PhysicsError("damping by modes needs modes that are real: gyroscopic or follower forces act here", ADVICE)
    if elements.n > LARGEST:
        raise PhysicsError(f"damping by modes is found up to {LARGEST} coordinates; here are {elements.n}", ADVICE)


def _modes(elements: FactoredSystem) -> "tuple[list[mpmath.mpf], list[list[mpmath.mpf]], list[list[mpmath.mpf]]]":
    """(ω² ascending, [φ], [M φ]) by M = L Lᵀ and the eigenvalues of L⁻¹ K L⁻ᵀ, massless coordinates following K."""
    import mpmath

    n = elements.n
    M, _, _, K = elements.matrices()
    heavy = [i for i in range(n) if i not in elements.massless]
    light = list(elements.massless)
    follow = mpmath.zeros(len(light), len(heavy))
    k = _block(K, heavy, heavy)
    if light:
        try:
            follow = -(_block(K, light, light) ** -1) * _block(K, light, heavy)
        except ZeroDivisionError:
            raise PhysicsError("damping by modes needs inertia or a spring along every coordinate",
                               "give what has neither a mass, tie it with a spring, or take it out") from None
        k = k + _block(K, heavy, light) * follow
    m = _block(M, heavy, heavy)
    try:
        lower = mpmath.cholesky(m)
    except ValueError:
        raise PhysicsError("damping by modes needs inertia along every coordinate that is no node", ADVICE) from None
    inverse = lower**-1
    values, vectors = mpmath.eigsy(inverse * k * inverse.T)
    moved = inverse.T * vectors
    largest = max(map(abs, values), default=mpmath.mpf(0))
    squares = [x if abs(x) > NOTHING * largest else mpmath.mpf(0) for x in values]
    whole = mpmath.zeros(n, len(heavy))
    for place, i in enumerate(heavy):
        whole[i, :] = moved[place, :]
    for place, i in enumerate(light):
        whole[i, :] = (follow * moved)[place, :]
    return squares, _columns(whole), [_cleaned(row) for row in _columns(_block(M, range(n), range(n)) * whole)]


def _block(matrix: "Mapping[tuple[int, int], mpmath.mpf]", rows: "range | Sequence[int]",
           columns: "range | Sequence[int]") -> "mpmath.matrix":
    import mpmath

    return mpmath.matrix([[matrix.get((i, j), 0) for j in columns] for i in rows])


def _columns(matrix: "mpmath.matrix") -> "list[list[mpmath.mpf]]":
    return [[matrix[i, j] for i in range(matrix.rows)] for j in range(matrix.cols)]


def _cleaned(row: "Sequence[mpmath.mpf]") -> "list[mpmath.mpf]":
    """Without what is rounding of zero."""
    largest = max(map(abs, row))
    return [x if abs(x) > NOTHING * largest else 0 * x for x in row]


def _require_one_ratio(squares: "Sequence[Any]", ratios: "Sequence[Any]") -> None:
    """Modes of one frequency have no shapes of their own."""
    for i in range(1, len(squares)):
        if squares[i] > 0 and ratios[i] != ratios[i - 1] and squares[i] - squares[i - 1] <= ALIKE * squares[i]:
            raise PhysicsError(f"modes {i} and {i + 1} have one frequency: what is damped by two ratios is not told "
                               "apart", "give both the same ratio")


def _of_series(given: "Mapping[int, mpmath.mpf]", squares: "Sequence[mpmath.mpf]",
               rates: "Sequence[mpmath.mpf]") -> "list[mpmath.mpf]":
    """p(ωᵢ²) of the Caughey series through the modes that are given {number: ζ}."""
    import mpmath

    numbers = sorted(given)
    for number in numbers:
        if number > len(squares) or not squares[number - 1] > 0:
            found = f"the last mode has the number {len(squares)}" if number > len(squares) else "it does not vibrate"
            raise PhysicsError(f"no ratio can be given to mode {number}: {found}", "name modes that vibrate")
    at = [squares[number - 1] for number in numbers]
    if any(two - one <= ALIKE * two for one, two in pairwise(at)):
        raise PhysicsError("two of the modes of `caughey` have one frequency", "give the ratio of one of them")
    size = at[-1]
    powers = mpmath.matrix([[(x / size) ** k for k in range(len(at))] for x in at])
    wanted = mpmath.matrix([2 * given[number] * rates[number - 1] for number in numbers])
    a = mpmath.lu_solve(powers, wanted)
    found = [mpmath.fsum(a[k] * (x / size) ** k for k in range(len(at))) for x in squares]
    largest = max(map(abs, found))
    found = [x if abs(x) > NOTHING * largest else mpmath.mpf(0) for x in found]
    for number, x in enumerate(found, 1):
        if x < 0:
            through = ", ".join(map(str, numbers))
            raise PhysicsError(f"the Caughey series through the modes {through} drives mode {number}",
                               f"give a ratio of mode {number} as well, or write `modal: […]`")
    return found
