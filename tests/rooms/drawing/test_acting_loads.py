"""Loads are drawn as they are when they act: blows and late ones in their direction, spread ones in their size."""

from pathlib import Path

import pytest
from support.scenes import kept_drawing_of, problem

from vibcli.drawing.canvas.primitives import ARROW, Polygon, Polyline
from vibcli.drawing.drawing import draw
from vibcli.drawing.layout import plane

ROOT = Path(__file__).parents[3]
BACK = "-S*impulse(t - 2 s)", "-F*step(t - 40 s)", "-F*ramp(t/1 s - 9)", "-F", "-F*cos(t/1 s)"


def _shafts(drawn):
    return [part.points for part in drawn if isinstance(part, Polyline) and part.role == "load" and part.layer == ARROW]


def _arrows(drawn):
    """[(the length of an arrow of a load, its direction)]."""
    tips = [part.points[0] for part in drawn if isinstance(part, Polygon) and part.role == "load"]
    return [(plane.distance(shaft[0], tip), plane.unit(plane.minus(tip, shaft[0])))
            for shaft, tip in zip(_shafts(drawn), tips, strict=True)]


@pytest.mark.parametrize("force", BACK)
@pytest.mark.parametrize(("order", "way"), [("[0, {}]", (0.0, -1.0)), ("[{}, 0]", (-1.0, 0.0))])
def test_a_force_is_drawn_in_the_direction_in_which_it_first_acts(force, order, way):
    drawn = draw(problem(f"""
        parameters: {{m: 2 kg, k: 900 N/m, l: 1 m, {"S: 4 N*s" if "S" in force else "F: 3 N"}}}
        bodies: {{p: {{mass: m, at: [0, 0], move: [x, y]}}}}
        springs: {{s: {{k: k, between: [[l, l], p]}}}}
        forces: {{f: {{at: p, force: {order.format(force)}}}}}
    """))
    (_, found), = _arrows(drawn)
    assert found == pytest.approx(way, abs=1e-9)


def test_the_blows_of_a_press_go_down():
    (_, found), = _arrows(kept_drawing_of(ROOT / "problems/5_forced/press_with_two_blows.yaml"))
    assert found == pytest.approx((0.0, -1.0))


@pytest.mark.parametrize(("spread", "size"), [
    ("q*x/L", lambda s: s), ("-q*x/L", lambda s: -s), ("q*(1 - x/L)*step(t - 7 s)", lambda s: 1 - s),
    ("q*(1 - 2*x/L)", lambda s: 1 - 2 * s), ("q*cos(3 rad/s*t)", lambda s: 1.0), ("q*sin(3 rad/s*t)", lambda s: 1.0)])
def test_arrows_of_a_spread_load_are_as_long_as_it_is_large(spread, size):
    drawn = draw(problem(f"""
        parameters: {{L: 2 m, EI: 4 kN*m^2, mu: 2 kg/m, q: 5 N/m}}
        beams: {{b: {{from: [0, 0], to: [L, 0], EI: EI, mass_per_length: mu, left: clamped}}}}
        forces: {{f: {{body: b, per_length: "{spread}"}}}}
    """))
    beam = next(part.points for part in drawn if isinstance(part, Polygon) and part.fill == "body")
    left, _, right, _ = plane.bounds(beam)
    found = {(shaft[0][0] - left) / (right - left): length * way[1]
             for shaft, (length, way) in zip(_shafts(drawn), _arrows(drawn), strict=True)}
    wanted = {place: size(place) for place in found}
    most = max(map(abs, wanted.values()))
    for place, length in found.items():
        assert length / 20.0 == pytest.approx(wanted[place] / most, abs=0.03)
    assert len(found) > 5
