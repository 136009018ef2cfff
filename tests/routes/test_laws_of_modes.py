"""Laws of modes, on scenes that hypothesis draws: how they follow what the scene is changed into, and what their sums,
products and counts are."""

from fractions import Fraction
from math import prod

import numpy as np
import pytest
from hypothesis import assume, given
from hypothesis import strategies as st
from support.laws import EPS, FEW, GROUND, LAW, SIZES, Row, plates, rates, rows, same

POWERS = st.integers(-6, 6)


@pytest.mark.sweep
@LAW
@given(rows(damped=True), POWERS, POWERS)
def test_powers_of_two_change_no_bit_of_rows(row, heavier, faster):
    """Masses × 4^a, times / 2^b: ω × 2^b, ζ as they were."""
    one = row.model()
    two = row.scaled(Fraction(4) ** heavier, Fraction(4) ** (heavier + faster),
                     Fraction(2) ** (2 * heavier + faster)).model()
    assert [2.0**faster * omega for omega in one.omega] == list(two.omega)
    assert np.array_equal(one.zeta, two.zeta, equal_nan=True)      # of one that does not vibrate it is NaN


@pytest.mark.sweep
@FEW
@given(plates(), POWERS)
def test_powers_of_two_change_no_bit_in_the_plane(plate, larger):
    """Lengths and g × 2^k: the same frequencies, the same angles of rest, displacements × 2^k."""
    one, two = plate.model(), plate.model(bits=larger)
    assert list(one.omega) == list(two.omega)
    assert {name: value * (2.0**larger if name in "xy" else 1) for name, value in one.equilibrium.items()
            } == two.equilibrium


@pytest.mark.sweep
@LAW
@given(rows(), st.randoms(use_true_random=False))
def test_bodies_and_springs_in_another_order(row, dice):
    order = list(range(len(row.masses)))
    dice.shuffle(order)
    springs = [(k, *ends[::dice.choice((1, -1))]) for k, *ends in row.springs]
    dice.shuffle(springs)
    assert same(rates(row.model()), rates(row._replace(springs=tuple(springs)).model(order)))


@pytest.mark.sweep
@FEW
@given(plates())
def test_a_mirror(plate):
    one, two = plate.model(), plate.model(lambda x, y: (-x, y))
    assert same(rates(one), rates(two))
    for name, sign in (("x", -1), ("y", 1), ("phi", -1), ("psi", -1)):
        left, right = one[f"equilibrium[{name}]"], two[f"equilibrium[{name}]"]
        assert abs(left.value - sign * right.value) <= left.error + right.error


@pytest.mark.sweep
@FEW
@given(plates(), st.tuples(st.integers(-99, 99), st.integers(-99, 99)), st.integers(0, 3))
def test_a_rigid_offset_and_quarter_turns(plate, shift, quarters):
    def turned(x, y):
        for _ in range(quarters):
            x, y = -y, x
        return x, y

    def place(x, y):
        return tuple(a + b for a, b in zip(turned(x, y), shift, strict=True))

    one, two = plate.model(), plate.model(place, turned(0, -1))
    assert same(rates(one), rates(two))
    for name in ("phi", "psi"):
        left, right = one[f"equilibrium[{name}]"], two[f"equilibrium[{name}]"]
        assert abs(left.value - right.value) <= left.error + right.error + 4 * EPS


@pytest.mark.sweep
@LAW
@given(rows(), st.data())
def test_springs_as_two_in_series_and_in_parallel(row, data):
    """k as k/p beside k(1 − 1/p), and as p·k behind k·p/(p − 1), a body without mass between them."""
    k, one, two = data.draw(st.sampled_from(row.springs))
    part = data.draw(st.integers(2, 9))
    rest = [spring for spring in row.springs if spring != (k, one, two)]
    assume(len(rest) == len(row.springs) - 1)
    found = rates(row.model())
    assert same(found, rates(Row(row.masses, (*rest, (k / part, one, two), (k - k / part, one, two))).model()))
    n = len(row.masses)
    split = Row((*row.masses, Fraction(0)), (*rest, (part * k, one, n), (part * k / (part - 1), n, two)))
    assert same(found, rates(split.model())[:n])


@pytest.mark.sweep
@LAW
@given(rows(), st.data(), SIZES)
def test_one_more_spring_or_mass_interlaces(row, data, size):
    """ωᵢ ≤ ωᵢ′ ≤ ωᵢ₊₁ with one more spring, ωᵢ₋₁ ≤ ωᵢ′ ≤ ωᵢ with one more mass (Rayleigh; Courant and Fischer)."""
    i = data.draw(st.integers(0, len(row.masses) - 1))
    before = rates(row.model())
    stiffer = rates(row._replace(springs=(*row.springs, (size, GROUND, i))).model())
    heavier = rates(row._replace(masses=tuple(m + size * (j == i) for j, m in enumerate(row.masses))).model())
    for low, high in ((before, stiffer), (stiffer[:-1], before[1:]), (heavier, before), (before[:-1], heavier[1:])):
        assert all(a - e <= b + f for (a, e), (b, f) in zip(low, high, strict=True))


@pytest.mark.sweep
@LAW
@given(rows())
def test_traces_and_determinants(row):
    """Σω² = tr M⁻¹K, Σω⁻² = tr K⁻¹M, Πω² = det K/det M, in fractions of the element data."""
    mass, _, stiffness = row.matrices()
    n = len(mass)
    squares = [omega**2 for omega in row.model().omega]
    assert sum(squares) == pytest.approx(float(sum(stiffness[i][i] / mass[i][i] for i in range(n))), rel=1e-13)
    flexible = inverse(stiffness)
    assert sum(1 / x for x in squares) == pytest.approx(float(sum(flexible[i][i] * mass[i][i] for i in range(n))),
                                                        rel=1e-13)
    wanted = prod(pivots(stiffness)) / prod(row.masses)
    assert prod(squares) == pytest.approx(float(wanted), rel=1e-13)


@LAW
@given(rows(held=False), st.data())
def test_as_many_as_are_counted_are_listed(row, data):
    """Below any ω there are as many as K − ω²M has negative pivots (Sylvester); one that moves freely is there."""
    omegas = row.model().omega
    assert omegas[0] == 0
    mass, _, stiffness = row.matrices()
    for i in range(len(omegas)):
        above = omegas[i + 1] if i + 1 < len(omegas) else 2 * omegas[i]
        assume(above > omegas[i] * (1 + 1e-9))
        shift = Fraction((omegas[i] + above) / 2) ** 2
        shifted = [[k - shift * m for k, m in zip(*pair, strict=True)] for pair in zip(stiffness, mass, strict=True)]
        assert sum(pivot < 0 for pivot in pivots(shifted)) == i + 1


def pivots(matrix):
    """The pivots of elimination, without exchanges."""
    rows_ = [list(row) for row in matrix]
    found = []
    while rows_:
        first, *rest = rows_
        found.append(first[0])
        rows_ = [[x - row[0] / first[0] * y for x, y in zip(row[1:], first[1:], strict=True)] for row in rest]
    return found


def inverse(matrix):
    n = len(matrix)
    wide = [[*row, *(Fraction(i == j) for j in range(n))] for i, row in enumerate(matrix)]
    for i in range(n):
        wide[i] = [x / wide[i][i] for x in wide[i]]
        wide = [row if j == i else [x - row[i] * y for x, y in zip(row, wide[i], strict=True)]
                for j, row in enumerate(wide)]
    return [row[n:] for row in wide]


def test_what_differs_is_not_the_same():
    assert same([(1.0, 1e-14)], [(1 + 1e-14, 1e-15)])
    assert not same([(1.0, 1e-14)], [(1 + 2e-14, 1e-15)])
    assert not same([(1.0, 1e-14)], [(1.0, 1e-14), (2.0, 1e-14)])
    assert pivots([[Fraction(2), Fraction(1)], [Fraction(1), Fraction(0)]]) == [2, Fraction(-1, 2)]
