"""Modes between stations of members: as where further stations stand, and as the differential equation says."""

import numpy as np
import pytest
from support.scenes import problem

from vibcli.analyses.modes import LAST
from vibcli.api.values import quantity_value
from vibcli.base.errors import PhysicsError, SpecError
from vibcli.quantities.index_kinds import MOST_NODES

KINDS = {
    "bars": ("EA: {k} N, mass_per_length: {m} kg/m", ("u", "force")),
    "shafts": ("GIo: {k} N*m^2, inertia_per_length: {m} kg*m", ("phi", "moment")),
    "beams": ("EI: {k} N*m^2, mass_per_length: {m} kg/m", ("u", "slope", "moment", "shear")),
    "strings": ("mass_per_length: {m} kg/m", ("u", "slope")),
}
ENDS = {"bars": ("clamped", "free"), "shafts": ("clamped", "free"), "strings": ("pinned",),
        "beams": ("clamped", "pinned", "guided")}


def member(kind, dice):
    """A member of three random segments, one of them without inertia perhaps, with something attached."""
    segments = []
    for _ in range(3):
        given = KINDS[kind][0].format(k=dice.uniform(50, 200), m=dice.uniform(0.5, 2))
        segments.append(f"{{length: {dice.uniform(0.5, 1.5)} m, {given}}}")
    left, right = (dice.choice(ENDS[kind]) for _ in range(2))
    turning = kind == "shafts"
    attached = [f"{{at: 1.1 m, {'inertia' if turning else 'mass'}: 2 {'kg*m^2' if turning else 'kg'}}}",
                f"{{at: 0.7 m, {'torsion: 30 N*m' if turning else 'k: 30 N/m'}}}"]
    own = {"strings": "preload: 80 N, ", "beams": "preload: 12 N, "}.get(kind, "")
    return (f"{kind}: {{a: {{{own}segments: [{', '.join(segments)}], left: {left}, right: {right}, "
            f"attached: [{', '.join(attached)}]}}}}\n")


@pytest.mark.sweep
@pytest.mark.parametrize("kind", KINDS)
@pytest.mark.parametrize("seed", range(2))
def test_further_stations_change_nothing(kind, seed):
    dice = np.random.default_rng(seed)
    scene = member(kind, dice)
    places = dice.uniform(0.05, 1.4, 2)
    points = "points: {" + ", ".join(f"p{i}: {{body: a, at: {x} m}}" for i, x in enumerate(places)) + "}\n"
    plain, refined = problem(scene), problem(scene + points)
    for mode in (2, 5):
        for part in KINDS[kind][1]:
            found, other = ([quantity_value(each, f"mode[{mode}][a.{part}({x} m)]").value for x in places]
                            for each in (plain, refined))
            assert found == pytest.approx(other, rel=1e-8, abs=1e-9), (mode, part)


def test_the_largest_displacement_of_the_first_member_is_one():
    scene = problem("""
        bars: {rod: {length: 2 m, EA: 90 N, mass_per_length: 1 kg/m, left: clamped, right: clamped}}
        strings: {cord: {length: 1 m, preload: 1 N, mass_per_length: 1 kg/m, left: pinned, right: pinned}}
    """)
    for mode, asked, value in ((1, "cord.u(0.5 m)", 1), (2, "cord.u(0.25 m)", 1), (2, "cord.u(0.75 m)", -1),
                               (1, "rod.u(1 m)", 0), (5, "rod.u(1 m)", 1), (5, "cord.u(0.5 m)", 0)):
        assert quantity_value(scene, f"mode[{mode}][{asked}]").value == pytest.approx(value, abs=1e-12), (mode, asked)


@pytest.mark.parametrize(("bond", "mode"), [("c: 3 N*s/m", 1), ("k: 4 kN/m", 1)])
def test_an_oscillator_that_moves_alone_is_one(bond, mode):
    """On a dashpot alone, without dampers; or at a place that is held."""
    scene = problem(f"beams: {{wing: {{length: 1 m, EI: 900 N*m^2, mass_per_length: 2 kg/m, left: clamped, "
                    f"right: pinned, attached: [{{at: 1 m, oscillator: {{mass: 1 kg, {bond}}}}}]}}}}")
    found = scene.modal.modes[mode - 1]
    for how in ("first", "largest", "mass"):
        assert [abs(x) for x in scene.modal.shape(found, how)] == [0, 1]


def test_massless_parts_are_straight_or_cubic():
    """A massless bar carries the force of what hangs at its end."""
    scene = problem("""
        bars: {rod: {left: clamped, segments: [{length: 1 m, EA: 100 N, mass_per_length: 1 kg/m},
                                               {length: 2 m, EA: 300 N}],
                     attached: [{at: 3 m, mass: 4 kg}]}}
    """)
    for mode in (1, 3):
        u = [quantity_value(scene, f"mode[{mode}][rod.u({x} m)]").value for x in (1, 2, 3)]
        assert u[1] == pytest.approx((u[0] + u[2]) / 2, rel=1e-10, abs=1e-12)
        omega = quantity_value(scene, f"omega[{mode}]").value
        for x in (1, 2, 3):
            force = quantity_value(scene, f"mode[{mode}][rod.force({x} m)]").value
            assert force == pytest.approx(4 * omega**2 * u[2], rel=1e-9)


def test_nodes_within_massless_parts_count():
    scene = problem("""
        bars: {rod: {left: clamped, right: clamped, length: 3 m, EA: 300 N,
                     attached: [{at: 1 m, mass: 4 kg}, {at: 2 m, mass: 4 kg}]}}
    """)
    assert quantity_value(scene, "node[2][rod, 1]").value == pytest.approx(1.5, rel=1e-12)


@pytest.mark.sweep
@pytest.mark.parametrize("k", [1e-3, 1e-6, 1e-12])
def test_shapes_of_close_frequencies_are_told_apart(k):
    """Two cantilevers that a weak spring ties, each with a weak spring of its own: beside one another K is 2 × 2."""
    scene = problem(f"""
        beams:
          a: {{length: 1 m, EI: 10 N*m^2, mass_per_length: 1 kg/m, left: clamped}}
          b: {{length: 1 m, EI: 10 N*m^2, mass_per_length: 1 kg/m, left: clamped, attached: [{{at: 1 m, k: {k} N/m}}]}}
        points: {{p: {{body: a, at: 1 m}}, q: {{body: b, at: 1 m}}}}
        springs: {{s: {{k: {k} N/m, between: [p, q]}}}}
    """)
    lower = (1 + 5**0.5) / 2            # K of both is k [[1, −1], [−1, 2]]
    for mode, ratio in ((1, 1 / lower), (2, -lower), (3, 1 / lower), (4, -lower)):
        a, b = (quantity_value(scene, f"mode[{mode}][{name}.u(1 m)]").value for name in "ab")
        assert b / a == pytest.approx(ratio, rel=1e-3 * k + 1e-9), mode


def test_nodes_are_counted_as_far_as_modes():
    scene = problem("strings: {cord: {length: 3 m, preload: 90 N, mass_per_length: 0.1 kg/m, left: pinned, "
                    "right: pinned}}")
    assert quantity_value(scene, "node[1200][cord, 1001]").value == pytest.approx(3 * 1001 / 1200, rel=1e-13)
    assert MOST_NODES == LAST
    with pytest.raises(PhysicsError, match="'cord' has 3 nodes in mode 4"):
        quantity_value(scene, f"node[4][cord, {LAST}]")
    with pytest.raises(SpecError, match=f"expected a whole number from 1 to {LAST} in square brackets"):
        quantity_value(scene, f"node[4][cord, {LAST + 1}]")


TURNING = """
    parameters: {m: 2 kg, Om: 2 rad/s, k: 100 N/m}
    coordinates: {x: m, y: m}
    bodies: {a: {mass: 1 kg, slide: x}, b: {mass: 1 kg, slide: y}}
    energies: {T: "m*Om*(x*y' - y*x')/2"}
    springs: {s: {k: k, between: [a, ground]}, t: {k: k, between: [b, ground]}}
    beams: {r: {length: 1 m, EI: 10 N*m^2, mass_per_length: 1 kg/m, left: clamped, right: {clamped: a}},
            apart: {length: 1 m, EI: 10 N*m^2, mass_per_length: 1 kg/m, left: clamped}}
    find: [{modes: 3}]
"""


def test_shapes_beside_gyroscopic_terms_in_more_digits():
    """Numbers of mpmath without an imaginary part are complex by their kind, which ended in a TypeError."""
    scene = problem(TURNING)
    for near, fine in zip(scene.modal.modes.shown(), scene.modal.modes_to(30).shown(), strict=True):
        for member in ("r", "apart"):
            place = scene.modal.fields(near).largest(member)[0]
            assert scene.modal.fields(fine).largest(member)[0] == pytest.approx(place, abs=1e-9)


def test_a_motion_beside_gyroscopic_terms_is_refused_before_shapes_are_taken_for_real(recwarn):
    scene = problem(TURNING + "    initial: {x: 1 mm, r.u: 1 mm*x^2/(1 m)^2*(3 - 2*x/(1 m))}")
    with pytest.raises(PhysicsError, match="gyroscopic terms couple"):
        quantity_value(scene, "r.u(0.5 m)(1 s)")
    assert not recwarn.list
