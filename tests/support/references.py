"""What tests of references share: a closed loop, and a true value beside a closed form and beside what we answer."""

import mpmath

CLOSED_LOOP = """
parameters: {a: 0.3 m, m: 2 kg, k: 800 N/m, g: 9.81 m/s^2}
gravity: g
bodies:
  left: {shape: rod, mass: m, from: [0, 0], to: [a, a], pin: {at: [0, 0], by: phi}}
  right: {shape: rod, mass: m, from: [a, a], to: [2*a, 0], pin: {at: [a, a], carrier: left, by: psi}}
  block: {mass: m, at: [2*a, 0], slide: {along: [1, 0], by: x}}
points: {foot: {body: right, at: [2*a, 0]}}
constraints: {pin: {join: [foot, block]}}
springs: {s: {k: k, between: [block, [1 m, 0]]}}
"""


def assert_true(found, exact, digits, most):
    """The reference is exact() to so many digits; ours is off it by its bound at most, and that by `most`."""
    with mpmath.workdps(60):
        assert abs(found.true.values[0] - exact()) <= mpmath.mpf(10) ** -digits * found.scale
    ours = found.ours()
    assert found.error(ours.values, found.true) <= ours.bound <= most
