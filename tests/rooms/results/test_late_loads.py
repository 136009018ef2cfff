"""Extremes of members whose loads begin long after they would have been looked at: none is missed."""

import pytest

import vibcli

TIP = "points: {tip: {body: b, at: 2 m}}\nforces: {f: {at: tip, force: 10 N*%s}}\n"
BAR = "bars: {b: {length: 2 m, EA: 4 MN, mass_per_length: 3 kg/m, left: clamped}}\n" + TIP
BEAM = "beams: {b: {length: 2 m, EI: 4 kN*m^2, mass_per_length: 3 kg/m, left: clamped}}\n" + TIP
DAMPED = BEAM.replace("left: clamped", "left: clamped, right: {c: 3 N*s/m}")
PLANE = BEAM.replace("{length: 2 m,", "{from: [0, 0], to: [2 m, 0], EA: 4 MN,").replace("10 N*%s", "[0 N, 10 N*%s]")


@pytest.mark.parametrize("scene", [BEAM, DAMPED, PLANE])
def test_a_load_that_begins_late(scene):
    late, early = (vibcli.loads(scene % load)["max(b.u(2 m))"] for load in ("step(t - 50 s)", "step(t)"))
    assert late.value == pytest.approx(early.value, rel=1e-3) and early.value > 1.2e-2


def test_waves_of_a_load_that_begins_late():
    assert vibcli.loads(BAR % "step(t - 0.5 s)")["max(b.u(2 m))"].value == pytest.approx(1e-5, rel=1e-12)
