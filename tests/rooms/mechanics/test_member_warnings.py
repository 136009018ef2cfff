"""Thick beams and large turns in equilibrium are told, in numbers by hand: w = PL³/3EI, w′ = PL²/2EI."""

import pytest
from support.scenes import problem

from vibcli.mechanics.member_warnings import member_warnings


def told(beam, parameters=""):
    scene = problem(f"gravity: 9.81 m/s^2\nparameters: {{M: 2 kg{parameters}}}\nbeams: {{arm: {{{beam}}}}}\n")
    return member_warnings(scene.configuration)


@pytest.mark.parametrize(("length", "thick"), [(1.4, True), (1.6, False)])
def test_a_beam_shorter_than_ten_times_its_height_is_thick(length, thick):
    found = told(f"length: {length} m, E: 11 GPa, section: {{rectangle: [0.3 m, 0.15 m]}}, left: clamped, "
                 "attached: [{at: 0.5 m, mass: M}]")
    assert [sentence.startswith("'arm' is thick") for sentence in found] == [True] * thick


@pytest.mark.parametrize(("slope", "large"), [(0.11, True), (0.09, False)])
def test_a_turn_of_more_than_a_tenth_is_told(slope, large):
    EI = 2 * 9.81 * 1.5**2 / (2 * slope)
    found = told(f"from: [0, 0], to: [1.5 m, 0], EI: {EI} N*m^2, left: clamped, attached: [{{at: 1.5 m, mass: M}}]")
    assert [sentence.split(" turns by ")[1][:4] for sentence in found] == ["0.11"] * large
