"""Steady even loads on strings up to an end that bears no tension: N u′ = what acts beyond, N = n (L − x)."""

import math
from itertools import pairwise

import pytest

import vibcli

GRADIENT, LOAD, LENGTH = 1.5 * 9.81, 0.3, 2.0


def chain(load="", held="left: clamped", more="", drawn="from: [0, 0], to: [0, -2 m]"):
    """A hanging one under a load from the side."""
    return vibcli.loads(f"title: A chain in the wind\ngravity: 9.81 m/s^2\n{more}strings: {{c: {{{drawn}, "
                        f"mass_per_length: 1.5 kg/m, {held}}}}}\n"
                        f"forces: {{wind: {{body: c, per_length: 0.3 N/m{load}}}}}\n")


def at_rest(p, signal):
    return p[f"equilibrium[{signal}]"].value


@pytest.mark.parametrize("x", [0.5, 1.7, 2.0])
def test_a_chain_in_the_wind_is_straight(x):
    assert at_rest(chain(), f"c.u({x} m)") == pytest.approx(LOAD * x / GRADIENT, rel=1e-14)
    upwards = chain(held="right: clamped", drawn="from: [0, -2 m], to: [0, 0]")
    assert at_rest(upwards, f"c.u({LENGTH - x} m)") == pytest.approx(LOAD * x / GRADIENT, rel=1e-14)


def beneath_a_mass(x, acting):
    """∫ acting/N, with a mass of 0.5 kg at 0.8 m below which nothing but the chain hangs, by Gauss's rule."""
    import numpy as np

    nodes, weights = np.polynomial.legendre.leggauss(40)
    cuts = sorted({0.0, 0.3, 0.8, 1.1, 1.5, x})
    total = 0.0
    for low, high in pairwise(cuts):
        if high <= x:
            z = (low + high) / 2 + (high - low) / 2 * nodes
            tension = GRADIENT * (LENGTH - z) + (0.5 * 9.81 if high <= 0.8 else 0.0)
            total += float((acting(z) / tension) @ weights) * (high - low) / 2
    return total


@pytest.mark.parametrize(("load", "start", "end"), [("", 0.0, 2.0), (", from: 0.8 m", 0.8, 2.0),
                                                    (", to: 1.5 m", 0.0, 1.5), (", from: 0.3 m, to: 1.1 m", 0.3, 1.1)])
@pytest.mark.parametrize("x", [0.8, 1.5])
def test_a_mass_on_the_way_and_a_part_of_the_load(load, start, end, x):
    found = at_rest(chain(load, "left: clamped, attached: [{at: 0.8 m, mass: 0.5 kg}]"), f"c.u({x} m)")
    acting = beneath_a_mass(x, lambda z: LOAD * (end - z.clip(start, end)))
    assert found == pytest.approx(acting, rel=1e-13)


def test_what_it_hangs_on_bears_the_whole_load():
    cart = ("bodies: {cart: {mass: 3 kg, at: [0, 0], move: [x, 0]}}\n"
            "springs: {k: {between: [[-1 m, 0], cart], k: 100 N/m}}\n")
    p = chain(held="left: {clamped: cart}", more=cart)
    assert p.equilibrium["x"] == pytest.approx(LOAD * LENGTH / 100, rel=1e-14)
    assert at_rest(p, "c.u(2 m)") == pytest.approx(LOAD * LENGTH * (1 / 100 + 1 / GRADIENT), rel=1e-14)


@pytest.mark.sweep
def test_frequencies_do_not_feel_it():
    assert chain()["omega[1]"].value == pytest.approx(2.404825557695773 / 2 * math.sqrt(9.81 / 2), rel=1e-14)
