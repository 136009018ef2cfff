"""What modes left out add to displacements where dampers couple those that `damping:` damps is bounded: against many
plain sine modes of a beam on pins, followed by the eigenvectors of their own first-order equations."""

import numpy as np
import pytest
from support.modes_found_once import modes_found_once  # noqa: F401
from support.scenes import problem

from vibcli.analyses.continuous.coupled_left_out import LOAD, RATE
from vibcli.analyses.continuous.given_denominators import GivenDenominators
from vibcli.analyses.excitation.linear_output import FieldPoint, LinearOutput
from vibcli.results.coupled_modal_response import CoupledModalResponse

BEAM = """
parameters: {L: 1 m, EI: 1 N*m^2, mu: 1 kg/m}
beams: {arm: {length: L, EI: EI, mass_per_length: mu, left: pinned, right: pinned, attached: [{at: L/2, c: C N*s/m}]}}
points: {aside: {body: arm, at: 0.3*L}}
damping: {DAMPING}
"""
PUSH = "forces: {push: {at: aside, force: %s}}\n"
C, Y, MANY = 0.7, 0.3, 150
TIMES = np.concatenate([np.geomspace(1e-5, 1e-2, 25), np.linspace(0.012, 0.5, 25)])
OUTPUTS = {0.3: FieldPoint(1, 0.0), 0.7: FieldPoint(2, 0.2)}
MODAL, STIFF = "modal: 1 %", "proportional: [0.3 s^-1, 0.01 s]"
pytestmark = pytest.mark.usefixtures("modes_found_once")


def _damping(given, omega):
    return {MODAL: 0.02 * omega, STIFF: 0.3 + 0.01 * omega**2}[given]


def _expected(given, c, start, load):
    """{x: u(TIMES)}: ż = A z + (0, b) f, of a step, or of a ramp that grows for 0.1 s, or from a start alone."""
    k = np.arange(1, MANY + 1) * np.pi
    omega, felt, b = k**2, np.sqrt(2) * np.sin(k / 2), np.sqrt(2) * np.sin(k * Y)
    none = np.zeros((MANY, MANY))
    A = np.block([[none, np.diag(omega)],
                  [-np.diag(omega), -np.diag(_damping(given, omega)) - c * np.outer(felt, felt)]])    # of (ω η, η̇)
    rates, X = np.linalg.eig(A)
    begun, driven = (np.linalg.solve(X, np.concatenate([0 * k, part])) for part in (start(k), b))
    t = TIMES[:, None]

    def held(t):
        return np.expm1(rates * t) / rates

    def grown(t):
        return (held(np.maximum(t, 0.0)) - np.maximum(t, 0.0)) / rates

    moved = {"step": held(t), "ramp": (grown(t) - grown(t - 0.1)) / 0.1, None: 0 * t}[load] * driven
    eta = np.real((np.exp(rates * t) * begun + moved) @ X[:MANY].T) / omega
    return {x: eta @ (np.sqrt(2) * np.sin(k * x)) for x in OUTPUTS}


def _still(k):
    return 0 * k


def _thrown(k):
    """⟨φ, v⟩ of v = (1 m/s) x/L."""
    return np.sqrt(2) * -np.cos(k) / k


@pytest.mark.parametrize(("given", "shares"), [(MODAL, (2, 20, 10, 10)), (STIFF, (4, 80, 40, 400))])
@pytest.mark.parametrize(("number", "c", "text", "start", "load"), [
    (0, C, PUSH % "1 N*step(t)", _still, "step"), (1, 50, PUSH % "1 N*step(t)", _still, "step"),
    (2, C, PUSH % "1 N*(ramp(t) - ramp(t - 0.1 s))/(0.1 s)", _still, "ramp"),
    (3, C, "initial: {arm.u': 1 m/s*x/L}\n", _thrown, None)])
def test_displacements_are_within_their_bound_which_is_not_far_more(given, shares, number, c, text, start, load):
    scene = BEAM.replace("C N", f"{c} N").replace("DAMPING", given) + text
    motion, expected = CoupledModalResponse(problem(scene)).motion(16), _expected(given, c, start, load)
    largest = 0.0
    for x, place in OUTPUTS.items():
        output = LinearOutput(places={place: 1.0})
        off, bound = np.abs(motion.values(output, TIMES) - expected[x]), motion.bound(output, 0.5)
        assert not motion.is_estimated(output) and off.max() <= bound + 1e-10 * np.abs(expected[x]).max()
        largest = max(largest, off.max() / bound)
    assert largest >= 1 / shares[number]


@pytest.mark.parametrize(("text", "output", "reason"), [
    (PUSH % "1 N*step(t)", LinearOutput(places={FieldPoint(1, 0.0, 2): 1.0}), RATE),
    (PUSH % "1 N*step(t)", LinearOutput(v={0: 1.0}), RATE),
    (PUSH % "1 N*s*impulse(t)", LinearOutput(places={FieldPoint(1, 0.0): 1.0}), LOAD)])
def test_forces_rates_and_blows_where_nothing_has_mass_are_estimated_and_why_is_said(text, output, reason):
    motion = CoupledModalResponse(problem(BEAM.replace("C N", "1 N").replace("DAMPING", MODAL) + text)).motion(16)
    assert motion.is_estimated(output) and motion.modes.disturbed(motion.forcing.pieces).reason(output) == reason


@pytest.mark.parametrize("given", [(0.02, 0.0, 0.0), (0.8, 0.0, 0.0), (0.0, 0.3, 0.01)])
def test_no_denominator_is_smaller_than_the_least_one(given):
    s = np.array([-3 + 40j, -0.5 + 9.9j, -99.0 + 0j, 5.0 + 0j, 4j])
    beyond, omega = GivenDenominators(*given, 10.0), 10 * np.geomspace(1, 1e6, 20_000)
    shares = omega**2 / np.abs(beyond.at(omega, s))
    assert (shares.max(axis=1) <= beyond.inverse(s)).all()
    assert beyond.inverse(s)[[1, 3, 4]] == pytest.approx(np.maximum(shares.max(axis=1), 1 / np.abs(
        1 + given[2] * s))[[1, 3, 4]], rel=1e-3)
