"""The energies of small motions: balanced where the motion is right, off by what it is wrong by."""

import numpy as np
import pytest
from support.scenes import problem, value

from vibcli.analyses.transient.exponential_sum import ExponentialSum
from vibcli.analyses.transient.linear_response import LinearMotion
from vibcli.results import energy_balance as balance
from vibcli.results.certificate import certificate

SCENE = """
parameters: {m: 2 kg, k: 300 N/m, c: 4 N*s/m, F: 20 N}
bodies: {a: {mass: m, slide: x}, b: {mass: m, slide: y}}
springs: {s: {k: k, between: [ground, a]}, t: {k: 2*k, between: [a, b]}}
dampers: {d: {c: c, between: [ground, b]}}
forces: {f: {at: a, force: %s}}
initial: {x: 3 cm, y': 0.2 m/s}
find: [{response: {until: %s}}]
"""
LOADS = "F*sin((5 rad/s)*t)", "F*step(t - 1 s)", "F*t/(1 s)", "F*sin((12 rad/s)*t)*exp(-t/(1 s))"


@pytest.mark.parametrize("load", LOADS)
def test_they_balance_to_rounding(load):
    one = problem(SCENE % (load, "3 s"))
    one.response.alone.pieces(3.0)
    assert 0 <= certificate(one)["energy balance"] <= 1e-14


@pytest.mark.parametrize("until", ["0.1 s", "3 s", "10000 s"])
def test_a_force_a_stiffness_a_damper_that_is_another_one_is_seen(until):
    motion = problem(SCENE % (LOADS[0], until)).response.alone
    end = float(until.split()[0])
    assert balance.energy_balance(motion, end) <= 1e-13
    M, C, K, _ = motion.matrices
    for wrong in ((M * 1.001, C, K, None), (M, C * 1.01, K, None), (M, C, K * 1.001, None)):
        other = LinearMotion(wrong, motion.blocks, motion.forcing, motion.q0, motion.v0)
        assert balance.energy_balance(other, end) > 1e-6


def test_few_instants_are_looked_at_and_no_stage_is_computed(monkeypatch):
    one, seen = problem(SCENE % ("F*square((7 rad/s)*t)", "60 s")), []
    motion = one.response.alone
    before, values = set(one.timings), ExponentialSum.at
    monkeypatch.setattr(ExponentialSum, "at", lambda summed, segment, tau, known: seen.append(
        (np.size(tau), id(known))) or values(summed, segment, tau, known))
    assert balance.energy_balance(motion, 60.0) <= 1e-13
    assert set(one.timings) == before
    assert len(set(seen)) == 1 and seen[0][0] == 2 * (balance.POINTS * balance.PARTS + 2) and len(seen) <= 2 * 2 + 1


def test_what_was_not_followed_is_not_followed_for_it():
    one = problem(SCENE % (LOADS[0], "3 s"))
    assert value(one, "amplitude(x)") and "response" in one.timings
    assert "energy balance" not in certificate(one) and not one.response.alone.is_followed


def test_what_was_not_found_is_not_found_for_it():
    one = problem(SCENE % (LOADS[0], "3 s"))
    assert not one.response.is_followed and "response" in one.timings
    assert "energy balance" not in certificate(one) and "alone" not in vars(one.response)


def test_of_integrated_motions_it_is_that_of_their_trajectory():
    one = problem("parameters: {m: 2 kg, k: 100 N/m}\nbodies: {b: {mass: m, slide: x}}\n"
                  "springs: {s: {law: 'k*d + (10 N/m^3)*d^3', between: [ground, b]}}\nmotion: full\n"
                  "initial: {x: 0.1 m}\nfind: [{response: {until: 2 s}}]\n")
    assert "energy balance" not in certificate(one)
    assert one.response.trajectory().balance.error == certificate(one)["energy balance"] <= 1e-12
