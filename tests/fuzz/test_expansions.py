"""Expansions of random scenes of springs by SymPy's series: `python -m fuzz.expansions 200` takes more of them."""

from fuzz.expansions import Compared, compared

SCENES = (0, 10, 12, 16, 17, 18, 27, 32, 36)


def test_expansions_equivalents_and_laws_agree_with_series_of_sympy():
    numbers, letters = [], []
    for seed in SCENES:
        _, found, refused, spelt = compared(seed)
        assert not refused
        numbers += found
        letters += spelt
    assert not [one for one in (*numbers, *letters) if not one.agrees]
    heads = {"V", "T", "law", "stiffness", "stiffness_correction"}
    assert heads == {one.text.partition("[")[0] for one in numbers} == {one.text.partition("[")[0] for one in letters}


def test_a_wrong_number_is_seen():
    right = Compared("V[x^2]", 2.0, 1e-15, 2.0, 2.0)
    assert right.agrees and not right._replace(found=2.0 * (1 + 1e-14)).agrees
