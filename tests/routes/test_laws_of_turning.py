"""Laws of what turns, with gyroscopic forces, and of linkages that close in loops, on scenes that hypothesis draws."""

from fractions import Fraction
from math import prod

import pytest
from hypothesis import given
from hypothesis import strategies as st
from support.laws import EPS, FEW, LAW, SIZES, rates, rows, same, written

import vibcli
from tests.routes.test_laws_of_modes import pivots
from tests.routes.test_laws_of_motions import reversed_back

POWERS = st.integers(-6, 6)
SPINS = st.lists(st.integers(-40, 40).filter(bool), min_size=10, max_size=10)


def spun(row, spins):
    """(M, G, K) of a row beside which each two coordinates are coupled by a gyroscopic force."""
    mass, _, stiffness = row.matrices()
    n, left = len(mass), iter(spins)
    G = [[Fraction(0)] * n for _ in range(n)]
    for i in range(n):
        for j in range(i):
            G[i][j] = Fraction(next(left)) / 10
            G[j][i] = -G[i][j]
    return mass, G, stiffness


def turning(mass, G, stiffness, order=None, **sections):
    """The scene of matrices, its coordinates in another order where one is given."""
    order = order or range(len(mass))

    def entries(rows_, unit):
        return [[written(rows_[i][j], unit) if rows_[i][j] else "0" for j in order] for i in order]

    return vibcli.load({"coordinates": {f"x{i}": "a displacement" for i in order}, "matrices": {
        "M": entries(mass, "kg"), "C": entries(G, "N*s/m"), "K": entries(stiffness, "N/m")}, **sections})


def scaled(factor, matrix):
    return [[factor * x for x in row] for row in matrix]


@pytest.mark.sweep
@LAW
@given(rows(most=4), SPINS)
def test_sums_and_products_of_frequencies(row, spins):
    """Σω² = tr M⁻¹K − tr (M⁻¹G)²/2, Πω² = det K/det M: coefficients of det(λ² M + λ G + K); each pair is listed."""
    mass, G, stiffness = spun(row, spins)
    n = len(mass)
    squares = [omega**2 for omega in turning(mass, G, stiffness).omega]
    assert len(squares) == n
    A = [[G[i][j] / mass[i][i] for j in range(n)] for i in range(n)]
    wanted = sum(stiffness[i][i] / mass[i][i] for i in range(n)) - sum(
        A[i][j] * A[j][i] for i in range(n) for j in range(n)) / 2
    assert sum(squares) == pytest.approx(float(wanted), rel=1e-13)
    assert prod(squares) == pytest.approx(float(prod(pivots(stiffness)) / prod(row.masses)), rel=1e-12)


@pytest.mark.sweep
@LAW
@given(rows(most=4), SPINS, POWERS, POWERS)
def test_powers_of_two_change_no_bit(row, spins, heavier, faster):
    """Masses × 4^a, times / 2^b: ω × 2^b."""
    mass, G, stiffness = spun(row, spins)
    one = turning(mass, G, stiffness)
    two = turning(scaled(Fraction(4) ** heavier, mass), scaled(Fraction(2) ** (2 * heavier + faster), G),
                  scaled(Fraction(4) ** (heavier + faster), stiffness))
    assert [2.0**faster * omega for omega in one.omega] == list(two.omega)


@pytest.mark.sweep
@LAW
@given(rows(most=4), SPINS, st.randoms(use_true_random=False))
def test_another_order_a_mirror_and_the_other_sense_of_turning(row, spins, dice):
    mass, G, stiffness = spun(row, spins)
    found, order = rates(turning(mass, G, stiffness)), list(range(len(mass)))
    dice.shuffle(order)
    assert same(found, rates(turning(mass, G, stiffness, order)))
    signs = [dice.choice((1, -1)) for _ in order]
    mirrored = ([[signs[i] * signs[j] * x for j, x in enumerate(line)] for i, line in enumerate(part)]
                for part in (mass, G, stiffness))
    assert same(found, rates(turning(*mirrored)))
    assert same(found, rates(turning(mass, scaled(-1, G), stiffness)))


@pytest.mark.sweep
@FEW
@given(rows(most=3), SPINS, st.integers(1, 20))
def test_time_run_backwards_turns_the_other_way(row, spins, tenths):
    """What is turned round in its velocities and its turning goes back; what turns on alone does not."""
    mass, G, stiffness = spun(row, spins)
    names, sense = [f"x{i}" for i in range(len(mass))], iter((1, -1))
    found = reversed_back(lambda **start: turning(mass, scaled(next(sense), G), stiffness, **start), names, tenths / 10,
                          {"x0": "1 cm", "x1'": "0.2 m/s"})
    for name, (value, _) in found.items():
        assert value == pytest.approx({"x0": 0.01, "x1'": 0.2}.get(name, 0.0), abs=1e-9)


# loops

LENGTHS = st.tuples(st.integers(4, 9), st.integers(4, 9), st.integers(6, 12), st.integers(1, 3))


def linkage(lengths, masses, place=lambda x, y: (x, y), down=(0, -1), bits=0, order=1, **sections):
    """The scene of rods that close a loop; `sections`: what stands beside them."""
    return vibcli.load({**rods(lengths, masses, place, down, bits, order), **sections})


def rods(lengths, masses, place=lambda x, y: (x, y), down=(0, -1), bits=0, order=1):
    """Two rods that hang from the ground, at places that lengths in eighths of a metre give, and a third that joins
    their lower ends: it closes a loop. `bits`: lengths and g times 2^bits."""
    unit = Fraction(2) ** bits

    def at(x, y):
        return [written(Fraction(c) / 8 * unit, "m") for c in place(x, y)]

    one, two, apart, lean = lengths
    A, B, C, D = (0, 0), (lean, -one), (apart + lean, -two), (apart, 0)
    bodies = {"left": {"shape": "rod", "mass": written(masses[0], "kg"), "from": at(*A), "to": at(*B),
                       "pin": {"at": at(*A), "by": "a"}},
              "between": {"shape": "rod", "mass": written(masses[1], "kg"), "from": at(*B), "to": at(*C),
                          "pin": {"at": at(*B), "carrier": "left", "by": "b"}},
              "right": {"shape": "rod", "mass": written(masses[2], "kg"), "from": at(*D), "to": at(*C),
                        "pin": {"at": at(*D), "by": "c"}}}
    return {"gravity": [written(Fraction(c) * Fraction(981, 100) * unit, "m/s^2") for c in down],
            "points": {"P": {"body": "between", "at": at(*C)}, "Q": {"body": "right", "at": at(*C)}},
            "bodies": dict(list(bodies.items())[::order]), "constraints": {"closed": {"join": ["P", "Q"]}}}


def rest(model):
    return {name: model[f"equilibrium[{name}]"] for name in "abc"}


@pytest.mark.sweep
@FEW
@given(LENGTHS, st.tuples(SIZES, SIZES, SIZES), st.integers(-3, 3))
def test_a_loop_follows_lengths_places_and_order(lengths, masses, bits):
    """Lengths and g × 2^k: the same frequencies to the last bit; a mirror, a quarter turn and an offset, the bodies in
    the other order: the same within the bounds."""
    plain = linkage(lengths, masses)
    found, angles = rates(plain), rest(plain)
    larger = linkage(lengths, masses, bits=bits)
    assert [omega for omega, _ in found] == list(larger.omega)
    assert {name: one.value for name, one in angles.items()} == {name: one.value for name, one in rest(larger).items()}
    for sign, other in ((-1, linkage(lengths, masses, lambda x, y: (-x, y))),
                        (1, linkage(lengths, masses, lambda x, y: (-y + 5, x - 3), (1, 0))),
                        (1, linkage(lengths, masses, order=-1))):
        assert same(found, rates(other))
        for name, one in rest(other).items():
            assert abs(sign * angles[name].value - one.value) <= angles[name].error + one.error + 4 * EPS


@pytest.mark.sweep
@FEW
@given(LENGTHS, st.tuples(SIZES, SIZES, SIZES))
def test_a_spring_at_a_loop_in_two_side_by_side(lengths, masses):
    def found(*springs):
        return rates(linkage(lengths, masses, springs={f"s{i}": {"torsion": f"{k} N*m", "between": ["ground", "left"]}
                                                       for i, k in enumerate(springs)}))

    assert same(found(30), found(10, 20))
