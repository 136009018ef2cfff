"""Variants of a scene as homework from Python: values, keys, bands, mistakes, counts."""

from math import sqrt

import pytest

import vibcli

SCENE = """title: A block
question: A block {m} on a spring {k}.
parameters: {m: 2 kg, k: 800 N/m}
bodies: {block: {mass: m, slide: x}}
springs: {s: {k: k, stretch: x}}
answers: {"omega[1]": 20.00 rad/s}
variants:
  parameters: {m: [1 kg, 2 kg, 3 kg]}
  require: ["omega[1] < 28 rad/s"]
  ask: {"omega[1]": rad/s, "equation[x]": }
cases:
  heavy: {variants: {parameters: {m: [5 kg]}, ask: {"period[1]": ms}}}
"""


def test_variants():
    found = vibcli.loads(SCENE).variants()
    assert found.counts["require"] == 1 and found.units == {"omega[1]": "rad/s", "equation[x]": ""}
    assert [one.values for one in found.accepted] == [{"m": "2 kg"}, {"m": "3 kg"}]
    (values, gate, reason), = found.rejected
    assert values == {"m": "1 kg"} and gate == "require" and "omega[1] < 28 rad/s" in reason
    for one, m in zip(found.accepted, (2, 3), strict=True):
        assert one.keys["omega[1]"] == pytest.approx(sqrt(800 / m), rel=1e-14)
        assert one.keys["equation[x]"] == f"{m}.00*x'' + 800*x = 0" and one.bands["equation[x]"] == pytest.approx(0.01)
        assert 0 < one.bands["omega[1]"] < 0.02 * one.keys["omega[1]"]
        assert one.mistakes["omega[1]"]["root forgotten"] == pytest.approx(800 / m, rel=1e-14)


def test_other_values_and_cases():
    assert vibcli.loads(SCENE).with_values(k=450).variants().accepted[0].keys["omega[1]"] == pytest.approx(sqrt(450))
    heavy = vibcli.loads(SCENE).case("heavy").variants()
    assert heavy.accepted[0].keys == {"period[1]": pytest.approx(1e3 * 2 * 3.14159265358979 / sqrt(160), rel=1e-13)}
    with pytest.raises(vibcli.SpecError, match="says nothing of variants"):
        vibcli.loads(SCENE.partition("variants:")[0]).variants()
