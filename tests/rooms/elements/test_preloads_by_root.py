"""Preloads of laws that have no inverse in closed form, against roots of mpmath."""

import mpmath
import numpy as np
import pytest

import vibcli
from vibcli.base.errors import PhysicsError
from vibcli.symbolic.branch_of_law import reached

SCENE = """
parameters: {m: 2 kg, k: 800 N/m, f: 10 N, a: 1 cm, c3: 3 MN/m^3, c5: 2 GN/m^5, N: 12 N}
bodies: {block: {mass: m, slide: x}}
springs: {s: {law: LAW, between: [ground, block], preload: N}}
forces: {w: {at: block, force: N}}
"""
VALUES = {"k": 800, "f": 10, "a": "0.01", "c3": 3e6, "c5": 2e9}
LAWS = {
    "k*d + f*tanh(d/a)": lambda d, k, f, a, c3, c5: k * d + f * mpmath.tanh(d / a),
    "k*d + c3*d^3 + c5*d^5": lambda d, k, f, a, c3, c5: k * d + c3 * d**3 + c5 * d**5,
    "f*sinh(d/a)": lambda d, k, f, a, c3, c5: f * mpmath.sinh(d / a),
    "k*d*exp(-d/a) + c3*d^3": lambda d, k, f, a, c3, c5: k * d * mpmath.exp(-d / a) + c3 * d**3,
}


def frequency(law, m="2", N="12", **changed):
    known = {name: mpmath.mpf(value) for name, value in {**VALUES, **changed}.items()}
    d = mpmath.findroot(lambda d: law(d, **known) - mpmath.mpf(N), (mpmath.mpf("1e-3"), mpmath.mpf("4e-2")),
                        solver="anderson")
    return mpmath.sqrt(mpmath.diff(lambda d: law(d, **known), d) / mpmath.mpf(m))


def _scene(law):
    unused = [name for name in ("k", "f", "a", "c3", "c5") if name not in law.replace("tanh", "").replace("exp", "")]
    text = SCENE.replace("LAW", law)
    for name in unused:
        text = text.replace(f", {name}: ", f", {name}_: ")
    lines = text.split("\n")
    inner = [part for part in lines[1][lines[1].index("{") + 1:-1].split(", ") if "_:" not in part]
    lines[1] = f"parameters: {{{', '.join(inner)}}}"
    return "\n".join(lines)


@pytest.mark.parametrize("written", LAWS)
def test_a_preload_shifts_a_law_along_its_branch(written):
    model = vibcli.loads(_scene(written))
    with mpmath.workdps(30):
        wanted = frequency(LAWS[written])
        by_N = mpmath.diff(lambda N: frequency(LAWS[written], N=N), 12)
    found = model["omega[1]"]
    assert found.value == pytest.approx(float(wanted), rel=1e-14)
    assert model["equilibrium[x]"].value == pytest.approx(0, abs=1e-17)
    assert model["sensitivity[1, N]"].value == pytest.approx(float(by_N), rel=1e-10)


@pytest.mark.sweep
def test_a_preload_is_chosen_and_set_to_other_numbers():
    text = _scene("k*d + f*tanh(d/a)")
    law = LAWS["k*d + f*tanh(d/a)"]
    with mpmath.workdps(20):
        wanted = mpmath.findroot(lambda N: frequency(law, N=N) - 22, (20, 22), solver="anderson")
    chosen = vibcli.loads(text.replace(", N: 12 N", "") + "choose:\n  N: omega[1] = 22 rad/s\n")
    assert chosen["N"].value == pytest.approx(float(wanted), rel=1e-10)
    with mpmath.workdps(20):
        assert vibcli.loads(text.replace("N: 12 N", "N: 3 N"))["omega[1]"].value == pytest.approx(
            float(frequency(law, N=3)), rel=1e-14)


def test_tensions_of_statics_are_found_on_laws_without_inverse():
    """A block of 2 kg hangs at rest as drawn."""
    text = """
parameters: {m: 2 kg, k: 800 N/m, f: 10 N, a: 1 cm, g: 9.81 m/s^2}
gravity: g
bodies: {block: {mass: m, at: [0, 0], slide: {by: x, along: [0, 1]}}}
springs: {s: {law: LAW, between: [block, [0, 1 m]], preload: static}}
"""
    model = vibcli.loads(text.replace("LAW", "k*d + f*tanh(d/a)"))
    with mpmath.workdps(20):
        wanted = frequency(LAWS["k*d + f*tanh(d/a)"], N="19.62")
    assert model["omega[1]"].value == pytest.approx(float(wanted), rel=1e-14)
    with pytest.raises(PhysicsError) as raised:
        vibcli.loads(text.replace("LAW", "f*tanh(d/a)").replace("k: 800 N/m, ", ""))["omega[1]"]
    assert "tension 19.62 N of 's', which its law does not rise to" in str(raised.value)


@pytest.mark.parametrize(("law", "force", "d", "most", "where"), [
    (lambda d: (np.sin(d), np.cos(d)), 0.5, np.pi / 6, None, None),
    (lambda d: (np.sin(d), np.cos(d)), -0.9999999, -np.arcsin(0.9999999), None, None),
    (lambda d: (np.sin(d), np.cos(d)), 1.01, np.nan, 1.0, np.pi / 2),
    (lambda d: (np.tanh(d), np.cosh(np.minimum(abs(d), 700.0)) ** -2), 1.5, np.nan, 1.0, np.inf),
    (lambda d: (d**3, 3 * d**2), 1e-24, 1e-8, None, None),
    (lambda d: (np.where(d <= 2, d, np.nan), 1 + 0 * d), 2.5, np.nan, 2.0, 2.0),
    (lambda d: (3 * d - d**3, 3 - 3 * d**2), -1.9, None, None, None)])
def test_the_branch_through_zero_is_followed_to_its_end(law, force, d, most, where):
    found = reached(law, force)
    if d is None:
        assert law(np.array(found.d))[0] == pytest.approx(force, rel=1e-15) and abs(found.d) < 1
    else:
        assert found.d == pytest.approx(d, rel=1e-9, nan_ok=True)
    if most is not None:
        assert (found.most, found.where) == (pytest.approx(most, rel=1e-12), pytest.approx(where, rel=1e-6))


def test_a_jump_past_the_tension_is_told():
    found = reached(lambda d: (2 * np.sign(d) + d, 1 + 0 * d), 1.0)
    assert found.jumps
    assert reached(lambda d: (2 * np.sign(d) + d, 1 + 0 * d), 3.0).d == pytest.approx(1)
