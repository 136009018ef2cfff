"""Zeros that rounding left are told as zeros, and small numbers that the data have as what they are."""

from pathlib import Path

from support.scenes import kept_problem_of, problem

DISC = Path(__file__).parents[3] / "problems"
COUPLED = """
parameters: {{m: 2 kg, k: 3 kN/m, weak: {weak} N/m}}
bodies: {{one: {{mass: m, slide: x}}, two: {{mass: m, slide: y}}}}
springs:
  a: {{k: k, between: [ground, one]}}
  b: {{k: k, between: [ground, two]}}
  c: {{k: weak, between: [one, two]}}
"""


def test_a_disc_on_three_tight_springs():
    path, = DISC.rglob("disc_on_three_tight_springs.yaml")
    found = kept_problem_of(path).configuration
    left = {pair for pair, value in found.linear_system.matrices()[3].items() if 0 < abs(value) < 1e-9}
    assert left                                     # of sines and cosines of 120°
    assert not left & set(found.told_matrices[3])
    assert all(found.told_matrices[3][i, i] == found.linear_system.matrices()[3][i, i] for i in range(3))


def test_small_entries_of_the_data_stay():
    for weak in ("1e-8", "1e-14"):
        found = problem(COUPLED.format(weak=weak)).configuration
        assert found.told_matrices[3][0, 1] == -float(weak)
