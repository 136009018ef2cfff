"""Laws of what turns and is damped, and of loops with springs and dampers, on scenes that hypothesis draws."""

from fractions import Fraction
from math import prod

import pytest
from hypothesis import given
from hypothesis import strategies as st
from numpy.polynomial.legendre import leggauss
from support.laws import FEW, LAW, SIZES, rates, rows, written

import vibcli
from tests.routes.test_laws_of_modes import inverse, pivots
from tests.routes.test_laws_of_motions import POINTS
from tests.routes.test_laws_of_turning import LENGTHS, POWERS, SPINS, rods, scaled, spun, turning

DAMPED = rows(most=4, damped=True)


def parts(row, spins):
    """(M, C + G, K)."""
    mass, G, stiffness = spun(row, spins)
    _, C, _ = row.matrices()
    return mass, [[c + g for c, g in zip(*pair, strict=True)] for pair in zip(C, G, strict=True)], stiffness


def eigenvalues(model):
    """[(λ, the bound of its relative error)] of all, of each pair both."""
    found = [(complex(mode.eigenvalue), mode.error) for mode in model._problem.modal.damped]
    return [one for value, error in found
            for one in [(value, error), *[(value.conjugate(), error)] * bool(value.imag)]]


def agree(found, others, factor=1.0):
    """Is each eigenvalue times a factor one of the others, within both bounds?"""
    left = list(others)
    for value, error in found:
        nearest = min(left, key=lambda one: abs(one[0] - factor * value))
        left.remove(nearest)
        assert abs(nearest[0] - factor * value) <= (error + nearest[1] + 1e-15) * abs(nearest[0])
    return not left


@pytest.mark.sweep
@LAW
@given(DAMPED, SPINS)
def test_sums_and_products_of_eigenvalues(row, spins):
    """Σλ = −tr M⁻¹C, Πλ = det K/det M, Σ1/λ = −tr K⁻¹C, Σλ² = tr (M⁻¹(C + G))² − 2 tr M⁻¹K: coefficients of
    det(λ²M + λ(C + G) + K). Sums are held to the sizes of what is summed."""
    mass, D, stiffness = parts(row, spins)
    n = len(mass)
    found = eigenvalues(turning(mass, D, stiffness))
    assert len(found) == 2 * n and all(value.real < 0 for value, _ in found)
    A, flexible = [[D[i][j] / mass[i][i] for j in range(n)] for i in range(n)], inverse(stiffness)
    squares = sum(A[i][j] * A[j][i] for i in range(n) for j in range(n)) - 2 * sum(
        stiffness[i][i] / mass[i][i] for i in range(n))
    for power, wanted in ((1, -sum(A[i][i] for i in range(n))), (2, squares),
                          (-1, -sum(flexible[i][j] * D[j][i] for i in range(n) for j in range(n)))):
        terms = [(value**power, abs(value**power) * (2 * error + 1e-15)) for value, error in found]
        assert abs(sum(term for term, _ in terms) - float(wanted)) <= sum(bound for _, bound in terms)
    assert prod(value for value, _ in found).real == pytest.approx(float(prod(pivots(stiffness)) / prod(row.masses)),
                                                                   rel=sum(error for _, error in found) + 1e-14)


@pytest.mark.sweep
@LAW
@given(DAMPED, SPINS, POWERS, POWERS, st.randoms(use_true_random=False))
def test_scales_another_order_a_mirror_and_the_other_sense_of_turning(row, spins, heavier, faster, dice):
    mass, D, stiffness = parts(row, spins)
    found, order = eigenvalues(turning(mass, D, stiffness)), list(range(len(mass)))
    assert agree(found, eigenvalues(turning(
        scaled(Fraction(4) ** heavier, mass), scaled(Fraction(2) ** (2 * heavier + faster), D),
        scaled(Fraction(4) ** (heavier + faster), stiffness))), 2.0**faster)
    dice.shuffle(order)
    assert agree(found, eigenvalues(turning(mass, D, stiffness, order)))
    signs = [dice.choice((1, -1)) for _ in order]
    assert agree(found, eigenvalues(turning(*([[signs[i] * signs[j] * x for j, x in enumerate(line)]
                                               for i, line in enumerate(part)] for part in (mass, D, stiffness)))))
    assert agree(found, eigenvalues(turning(mass, [list(line) for line in zip(*D, strict=True)], stiffness)))


def energy_is_lost_to_dampers(model, end):
    """T + V at the start without that at the end = ∫ 2Φ dt, by Gauss's rule."""
    first, last = (sum(model[f"{energy}({t!r} s)"].value for energy in "TV") for t in (0.0, end))
    nodes, weights = leggauss(POINTS)
    lost = sum(weight * end * model[f"Phi({float(end * (node + 1) / 2)!r} s)"].value
               for node, weight in zip(nodes, weights, strict=True))
    assert first - last == pytest.approx(lost, rel=1e-7, abs=1e-13 * first) and lost > 0


@pytest.mark.sweep
@FEW
@given(rows(most=3, damped=True), SPINS)
def test_what_turns_takes_no_energy_and_dampers_do(row, spins):
    mass, D, stiffness = parts(row, spins)
    end = float(1 / sum(turning(mass, D, stiffness).omega))
    energy_is_lost_to_dampers(turning(mass, D, stiffness, initial={"x0": "1 cm", "x1'": "0.2 m/s"}), end)


# loops

def held(lengths, masses, stiffnesses, disc, **sections):
    """Rods without weight that close a loop, held as drawn by springs of torsion, and a disc on a spring of its own
    that turns on the third."""
    scene = rods(lengths, masses, down=(0, 0))
    scene["bodies"]["disc"] = {"shape": "disc", "mass": written(disc, "kg"), "radius": "0.2 m", "at": "P",
                               "pin": {"at": "P", "carrier": "between", "by": "d"}}
    ends = (["ground", "left"], ["between", "disc"], ["ground", "right"])
    springs = {f"s{i}": {"torsion": written(k, "N*m"), "between": pair}
               for i, (k, pair) in enumerate(zip(stiffnesses, ends, strict=False))}
    return vibcli.load({**scene, "springs": springs, **sections})


@pytest.mark.sweep
@FEW
@given(LENGTHS, st.tuples(SIZES, SIZES, SIZES), st.tuples(SIZES, SIZES, SIZES), SIZES)
def test_one_more_spring_at_a_loop_interlaces_and_more_mass_slows(lengths, masses, stiffnesses, disc):
    """ωᵢ ≤ ωᵢ′ ≤ ωᵢ₊₁ with one more spring; with a heavier rod no frequency rises (Courant and Fischer)."""
    before = rates(held(lengths, masses, stiffnesses[:2], disc))
    stiffer = rates(held(lengths, masses, stiffnesses, disc))
    slower = rates(held(lengths, (masses[0], 2 * masses[1], masses[2]), stiffnesses[:2], disc))
    assert len(before) == len(stiffer) == len(slower) == 2
    for low, high in ((before, stiffer), (stiffer[:-1], before[1:]), (slower, before)):
        assert all(a - e <= b + f for (a, e), (b, f) in zip(low, high, strict=True))


@pytest.mark.sweep
@FEW
@given(LENGTHS, st.tuples(SIZES, SIZES, SIZES), st.tuples(SIZES, SIZES, SIZES), SIZES, SIZES)
def test_energy_of_a_loop_is_lost_to_its_damper_alone(lengths, masses, stiffnesses, disc, c):
    """½ q̇ᵀM q̇ + ½ qᵀK q of small motions falls by ∫ q̇ᵀC q̇ dt, M, C and K being those that are told of the loop."""
    damper = {"c": {"torsion": written(c, "N*m*s"), "between": ["ground", "left"]}}
    start = {"a": "0.1 rad", "d'": "0.5 rad/s"}
    end = float(1 / sum(held(lengths, masses, stiffnesses, disc).omega))
    for dampers in ({}, {"dampers": damper}):
        model = held(lengths, masses, stiffnesses, disc, initial=start, motion="small", **dampers)

        def form(letter, time, prime, model=model):
            q = {name: model[f"{name}{prime}({time!r} s)"].value for name in "ad"}
            return sum(model[f"{letter}[{one},{two}]"].value * q[one] * q[two] for one in q for two in q)

        first, last = ((form("M", t, "'") + form("K", t, "")) / 2 for t in (0.0, end))
        lost = sum(weight * end / 2 * form("C", float(end * (node + 1) / 2), "'")
                   for node, weight in zip(*leggauss(POINTS), strict=True)) if dampers else 0.0
        assert first - last == pytest.approx(lost, rel=1e-7, abs=1e-12 * first) and (lost > 0) == bool(dampers)
