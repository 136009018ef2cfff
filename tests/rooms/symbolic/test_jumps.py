"""Impulses take what multiplies them at their instants; displacements by pulses have the rates that they have."""

import pytest
from support.scenes import problem, value


@pytest.mark.parametrize(("travel", "push"), [
    ("a/2*t^2*step(t)", "step(t)"),
    ("a/2*(t^2*step(t) - (t - T)^2*step(t - T))", "(step(t) - step(t - T))"),
    ("a/2*ramp(t)*ramp(t) - a/2*ramp(t - T)^2", "(step(t) - step(t - T))"),
])
def test_a_carrier_that_starts_and_stops_acts_by_its_acceleration(travel, push):
    """A mass on a spring within a carrier feels −m a, as it does by a force."""
    carried = problem(f"""
        parameters: {{m: 2 kg, k: 50 N/m, a: 3 m/s^2, T: {{value: 0.4 s, unused: allowed}}}}
        bodies:
          cart: {{at: [0, 0], slide: "{travel}"}}
          block: {{mass: m, at: [0, 0], slide: {{along: [1, 0], by: x, carrier: cart}}}}
        springs: {{s: {{k: k, stretch: x}}}}
    """)
    pushed = problem(f"""
        parameters: {{m: 2 kg, k: 50 N/m, a: 3 m/s^2, T: {{value: 0.4 s, unused: allowed}}}}
        bodies: {{block: {{mass: m, slide: x}}}}
        springs: {{s: {{k: k, between: [ground, block]}}}}
        forces: {{f: {{at: block, force: "-m*a*{push}"}}}}
    """)
    for asked in ("x(0.1 s)", "x(0.7 s)", "x'(0.3 s)", "max(x)", "min(x)"):
        assert value(carried, asked) == pytest.approx(value(pushed, asked), rel=1e-12, abs=1e-14)
    assert value(carried, "min(x)") < -0.05


def test_a_displacement_that_jumps_is_refused_where_its_acceleration_counts():
    from vibcli.base.errors import PhysicsError

    scene = problem("""
        parameters: {m: 2 kg, k: 50 N/m, a: 3 cm}
        bodies:
          cart: {at: [0, 0], slide: a*step(t - 1 s)}
          block: {mass: m, at: [0, 0], slide: {along: [1, 0], by: x, carrier: cart}}
        springs: {s: {k: k, stretch: x}}
    """)
    with pytest.raises(PhysicsError, match="jumps"):
        value(scene, "x(2 s)")
