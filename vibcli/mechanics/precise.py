"""Equilibrium and element data to any number of digits, by Newton's method in mpmath from the float solution."""

from vibcli.algebra.evaluate import multiprecision
from vibcli.errors import PhysicsError
from vibcli.mechanics.elements import OscillatorElements
from vibcli.mechanics.linearise import in_numbers

ROUNDED = 40
GUARD = 30      # digits beyond those asked: near a bifurcation a singular K takes up many of them


def elements_to(problem, digits):
    """OscillatorElements of mpmath numbers, good to `digits` digits."""
    import mpmath

    with mpmath.workdps(digits + GUARD):
        arithmetic = multiprecision()
        values = problem.values(arithmetic)
        if problem.equilibrium.drawn:
            return in_numbers(problem.drawn_form, arithmetic, values, problem.rational).elements
        return in_numbers(problem.form, arithmetic, {**values, **equilibrium_to(problem, values, arithmetic)},
                          problem.rational).elements


def equilibrium_to(problem, values, arithmetic):
    """{coordinate: mpf} in equilibrium at the working precision."""
    import mpmath

    names = problem.scene.coordinates
    q = [mpmath.mpf(problem.equilibrium.values[name]) for name in names]
    for _ in range(60):
        numbers = in_numbers(problem.form, arithmetic, {**values, **dict(zip(names, q, strict=True))})
        step = _newton_step(numbers, mpmath)
        q = [a + d for a, d in zip(q, step, strict=True)]
        if max(map(abs, step)) <= mpmath.eps * 10 ** (GUARD - 3) * (1 + max(map(abs, q))):
            return dict(zip(names, q, strict=True))
    raise PhysicsError("the equilibrium does not converge to more digits: it is degenerate", "ask for fewer digits")


def _newton_step(numbers, mpmath):
    """−K⁻¹ r; coordinates that nothing holds stay where they are."""
    n = numbers.elements.n
    K = numbers.elements.stiffness()
    held = [i for i in range(n) if any(K.get((i, j)) for j in range(n))]
    step = [mpmath.mpf(0)] * n
    if held:
        block = mpmath.matrix([[K.get((i, j), 0) for j in held] for i in held])
        try:
            found = mpmath.lu_solve(block, mpmath.matrix([-numbers.residual[i] for i in held]))
        except ZeroDivisionError:
            raise PhysicsError("the equilibrium is not isolated: it cannot be refined to more digits") from None
        for i, value in zip(held, found, strict=True):
            step[i] = value
    return step


def rounded_elements(problem):
    """The element data at an equilibrium that was searched for, each number correctly rounded."""
    exact = elements_to(problem, ROUNDED)
    return OscillatorElements(
        exact.n, _rows(exact.inertias), _rows(exact.springs), _rows(exact.dampers), M=_floats(exact.M),
        C=_floats(exact.C), G=_floats(exact.G), K=_floats(exact.K),
        K_size={pair: abs(float(x)) for pair, x in exact.K.items()},
        rational_rows=exact.rational_rows, massless=exact.massless)


def _rows(terms):
    return [(float(weight), {i: float(x) for i, x in row.items()}) for weight, row in terms]


def _floats(entries):
    return {pair: float(x) for pair, x in entries.items()}
