"""Loads on bodies in rows have arrows of their own above the elements there, and names stand beside what they name."""

import pytest
from support.overlaps import crossed, touching
from support.scenes import problem

from vibcli.drawing.canvas.primitives import ARROW, LetterRuns, Polyline
from vibcli.drawing.drawing import draw

ROW = """
    parameters: {m: 1 kg, k: 1 kN/m, mu: 0.1, c: 2 N*s/m, F: 3 N, P: 2 N, W: 5 rad/s}
    bodies: {one: {mass: m, slide: x}, two: {mass: m, slide: y}}
    springs: {s: {k: k, between: [ground, one]}, t: {k: 'k*mu/(1 + mu)^2', between: [one, two]}}
    dampers: {d: {c: c, between: [one, two]}}
    forces: {first: {at: one, force: F*sin(W*t)}, second: {at: one, force: P*cos(W*t)}}
"""


def names(figure):
    return {"".join(run.text for run in part.runs): part.box for part in figure if isinstance(part, LetterRuns)}


def test_two_forces_on_a_body_have_two_arrows_above_the_spring_beside_it():
    figure = draw(problem(ROW))
    arrows = [part.points for part in figure
              if isinstance(part, Polyline) and part.layer == ARROW and part.role == "load"]
    springs = [part.points for part in figure if part.role == "spring" and len(part.points) > 4]
    assert len(arrows) == 2 and abs(arrows[0][0][1] - arrows[1][0][1]) > 10
    assert min(y for points in arrows for _, y in points) > max(y for points in springs for _, y in points)
    assert crossed(figure) == touching(figure) == []


def test_names_of_elements_side_by_side_stand_on_their_own_side():
    figure = draw(problem(ROW))
    damper = next(part for part in figure if part.role == "damper" and part.width > 1.5).points[0][1]
    found = names(figure)
    long = next(box for name, box in found.items() if "/" in name)
    assert long[1] > damper > found["c"][3]


def test_a_gap_is_as_wide_as_the_names_in_it():
    widths = {}
    for k in ("k", "kmm*mu/(mu + 3)"):
        figure = draw(problem(f"""
            parameters:
              m: 1 kg
              k: {{value: 1 kN/m, unused: allowed}}
              kmm: {{value: 1 kN/m, unused: allowed}}
              mu: {{value: 0.1, unused: allowed}}
            bodies: {{one: {{mass: m, slide: x}}, two: {{mass: m, slide: y}}}}
            springs: {{t: {{k: {k}, between: [one, two]}}}}
        """))
        widths[k] = max(part.points[-1][0] - part.points[0][0] for part in figure if part.role == "spring")
    assert widths["kmm*mu/(mu + 3)"] > widths["k"] + 2


@pytest.mark.parametrize("mass", ["0", "0 kg", "m"])
def test_a_body_without_mass_has_no_name(mass):
    figure = draw(problem(f"""
        parameters: {{m: {{value: 1 kg, unused: allowed}}, M: 1 kg, L: 1 m}}
        bodies: {{arm: {{shape: rod, mass: M, from: [0, 0], to: [0, L], pin: {{at: [0, 0], by: phi}}}},
                  tip: {{mass: {mass}, at: [0, L], slide: {{along: [1, 0], by: x}}}}}}
        springs: {{s: {{k: 3 N/m, between: [tip, [L, L]]}}, t: {{torsion: 3 N*m, between: [ground, arm]}}}}
    """))
    assert {"0", "0 kg", "m"} & set(names(figure)) == {"m"} & {mass}
