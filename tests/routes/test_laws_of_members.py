"""Laws of members, on strings with beads and beams that hypothesis draws: counts, interlacing, powers of two, the other
end first, pieces put together."""

import math
from fractions import Fraction
from itertools import pairwise

import pytest
from hypothesis import given
from hypothesis import strategies as st
from support.laws import FEW, same, told, written

import vibcli

MODES = 6
BEADS = st.lists(st.tuples(st.integers(1, 31), st.integers(1, 400)), max_size=3, unique_by=lambda bead: bead[0])
SIZES = st.integers(10, 999)
ENDS = st.sampled_from(["clamped", "pinned", "free", "guided"])


def string(tension, density, beads, bits=(0, 0), turned=False):
    """A string of 2 m between two supports, its beads (place in sixteenths of a metre, grams); masses times 2^bits[0],
    tension times 2^bits[1]."""
    heavy, tight = (Fraction(2) ** bit for bit in bits)
    attached = [{"at": written(Fraction(32 - at if turned else at, 16), "m"),
                 "mass": written(heavy * Fraction(grams, 1000), "kg")} for at, grams in beads]
    data = {"length": "2 m", "preload": written(tight * tension, "N"), "left": "pinned", "right": "pinned",
            "mass_per_length": written(heavy * Fraction(density, 1000), "kg/m")}
    return vibcli.load({"strings": {"s": data | ({"attached": attached} if beads else {})}})


def lowest(model, count=MODES):
    return [told(model, f"omega[{i + 1}]") for i in range(count)]


def nodes(tension, density, beads, omega):
    """The zeros in 0 < x ≤ 2 m of the string that starts with u = 0, u' = 1 and swings with omega: as many as there are
    frequencies up to omega (Sturm). Each piece turns the phase of (k u, u') evenly, each bead jumps u'."""
    k = omega * math.sqrt(density / 1000 / tension)
    u, slope, count, here = 0.0, 1.0, 0, 0.0
    for at, mass in [*sorted((at / 16, grams / 1000) for at, grams in beads), (2.0, 0.0)]:
        phase = math.atan2(k * u, slope)
        size, end = math.hypot(u, slope / k), phase + k * (at - here)
        count += math.floor(end / math.pi) - math.floor(phase / math.pi)
        u, slope, here = size * math.sin(end), size * k * math.cos(end), at
        slope -= mass * omega**2 / tension * u
    return count


@pytest.mark.sweep
@FEW
@given(SIZES, SIZES, BEADS)
def test_as_many_as_are_counted_are_listed(tension, density, beads):
    omegas = [omega for omega, _ in lowest(string(tension, density, beads))]
    for i, (low, high) in enumerate(pairwise(omegas)):
        assert low < high and nodes(tension, density, beads, (low + high) / 2) == i + 1


@pytest.mark.sweep
@FEW
@given(SIZES, SIZES, BEADS, st.tuples(st.integers(1, 31), st.integers(1, 400)))
def test_one_more_bead_interlaces(tension, density, beads, more):
    before = lowest(string(tension, density, beads))
    after = lowest(string(tension, density, [*beads, more]))
    for low, high in ((after, before), (before[:-1], after[1:])):
        assert all(a - e <= b + f for (a, e), (b, f) in zip(low, high, strict=True))


@pytest.mark.sweep
@FEW
@given(SIZES, SIZES, BEADS, st.integers(-5, 5), st.integers(-5, 5))
def test_powers_of_two_change_no_bit(tension, density, beads, heavy, tight):
    """Masses × 4^a, tension × 4^b: ω × 2^(b − a)."""
    one, two = (string(tension, density, beads, bits) for bits in ((0, 0), (2 * heavy, 2 * tight)))
    assert [2.0 ** (tight - heavy) * omega for omega, _ in lowest(one)] == [omega for omega, _ in lowest(two)]


@pytest.mark.sweep
@FEW
@given(SIZES, SIZES, BEADS)
def test_the_other_end_first(tension, density, beads):
    assert same(lowest(string(tension, density, beads)), lowest(string(tension, density, beads, turned=True)))


def beam(left, right, **more):
    data = {"EI": "90 N*m^2", "mass_per_length": "3 kg/m", "left": left, "right": right, **more}
    return vibcli.load({"beams": {"b": data}})


@pytest.mark.sweep
@FEW
@given(ENDS, ENDS, st.integers(1, 15), st.integers(1, 15), SIZES)
def test_pieces_of_a_beam_and_halves_of_a_mass(left, right, one, two, grams):
    """A beam of three pieces that are alike is one; a mass is two halves of it at one place."""
    place, last = sorted((one, one + two))
    pieces = [{"length": f"{length}/32*(1 m)"} for length in (place, last - place, 32 - last)]
    halves = [{"at": f"{place}/32*(1 m)", "mass": f"{grams / 2000} kg"}] * 2
    whole = [{"at": f"{place}/32*(1 m)", "mass": f"{grams / 1000} kg"}]
    assert same(lowest(beam(left, right, length="1 m", attached=whole)),
                lowest(beam(left, right, segments=pieces, attached=halves)))


@pytest.mark.sweep
@FEW
@given(ENDS, ENDS, st.integers(1, 31), st.booleans())
def test_one_more_support_interlaces(left, right, place, spring):
    """ωᵢ ≤ ωᵢ′ ≤ ωᵢ₊₁, whether what is added gives way or not."""
    held = {"at": f"{place}/32*(1 m)", **({"k": "500 N/m"} if spring else {"support": "pinned"})}
    before, after = (lowest(beam(left, right, length="1 m", **more)) for more in ({}, {"attached": [held]}))
    for low, high in ((before, after), (after[:-1], before[1:])):
        assert all(a - e <= b + f for (a, e), (b, f) in zip(low, high, strict=True))


def test_nodes_of_a_plain_string_are_counted():
    """1 N and 1 kg/m: ω = iπ/2."""
    assert [nodes(1, 1000, [], x * math.pi / 2) for x in (0.9, 1.1, 1.9, 5.5)] == [0, 1, 1, 5]
