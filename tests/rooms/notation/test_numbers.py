"""Numbers as they are printed."""

from vibcli.notation.numbers import rounded_up, supported


def test_bounds_are_printed_rounded_up():
    assert rounded_up(1.11e-16) == 2e-16
    assert rounded_up(9.01e-5) == 1e-4
    assert rounded_up(1.01, digits=2) == 1.1
    assert rounded_up(9.91e3, digits=2) == 1e4
    assert [rounded_up(x) for x in (2e-16, 0.5, 0.0, float("inf"))] == [2e-16, 0.5, 0.0, float("inf")]
    assert supported(1.0, 10.2) == "0 ± 2e1"
