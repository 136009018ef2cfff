"""Motions in time and frequency responses of every file, as text, data and curves: finite numbers, or a refusal that
says why. Letters are given values as well."""

import re
from math import isfinite
from pathlib import Path

import numpy as np
import pytest
from support.scenes import kept_instances_of, kept_problem_of, kept_settled_of

from vibcli.base.errors import PhysicsError
from vibcli.inverse import settled
from vibcli.plots.braille import braille
from vibcli.report.document import Report
from vibcli.report.formats.text import render
from vibcli.report.sections.frequency_response import frequency_response_data
from vibcli.report.sections.motion_data import response_data
from vibcli.report.sections.sampled_series import frequency_figure, response_figure, sampled, sampled_curves
from vibcli.report.wanted import Wanted

ROOT = Path(__file__).parents[2]
FILES = sorted([*ROOT.glob("problems/*/*.yaml"), *ROOT.glob("vibcli/examples/*.yaml")])
NO_NUMBER = re.compile(r"(?<!\w)(nan|inf|infinity|[\d.]+j)(?!\w)", re.IGNORECASE)
WANTED = Wanted(points=40)
DRAWN = 500     # places of a curve over frequency: it is as finite where more of them are drawn


def problems_of(path):
    """The scene and its cases with what they choose; where a scene holds letters, the same in numbers as well."""
    scene = kept_problem_of(path)
    for case in ("", *scene.spec.cases):
        problem = settled(scene.case(case)) if case else kept_settled_of(path)
        if problem.numeric.has_free_symbols:
            yield problem
        numeric = next(iter(kept_instances_of(path, case)), None)
        if numeric is not None:
            yield numeric


def finite(data):
    """Are all numbers in a piece of data real and finite?"""
    if isinstance(data, dict):
        data = list(data.values())
    if isinstance(data, list | tuple):
        return all(map(finite, data))
    return data is None or isinstance(data, str | bool) or (isinstance(data, int | float) and isfinite(data))


def text(problem):
    """The sections of both kinds; the first refusal, or None."""
    report = Report(problem, wanted=WANTED)
    for name in ("response", "frequency_response"):
        report.add(name)
    assert not NO_NUMBER.findall(render([report.document(question=False)]).partition("\n")[2])
    if report.refusal:
        raise report.refusal


def in_time(problem):
    assert finite(response_data(problem, WANTED))
    series = sampled(problem, WANTED)
    assert all(np.isfinite(one.values).all() and len(one.values) == WANTED.points for one in series)
    assert not NO_NUMBER.findall(braille(response_figure(problem, series)).partition("\n")[2])


def over_frequency(problem):
    assert finite(frequency_response_data(problem, WANTED))
    curves = sampled_curves(problem, WANTED)
    assert not any(np.isinf(curve.values).any() for curve in curves)
    every = len(curves[0].Omega) // DRAWN + 1
    curves = [curve._replace(Omega=curve.Omega[::every], values=curve.values[::every]) for curve in curves]
    for nyquist in (False, True):
        assert not NO_NUMBER.findall(braille(frequency_figure(problem, curves, nyquist)).partition("\n")[2])


def test_curves_in_the_complex_plane_are_smooth_and_their_points_lie_on_them():
    problem = kept_problem_of(ROOT / "problems/6_two_degrees/quarter_car_damped.yaml")
    panel, = frequency_figure(problem, sampled_curves(problem, WANTED), nyquist=True).panels
    lines = [np.array(curve.x) + 1j * np.array(curve.y) for curve in panel.curves if curve.kind == "line"]
    points, = [np.array(curve.x) + 1j * np.array(curve.y) for curve in panel.curves if curve.kind == "markers"]
    assert len(lines) == 2 and len(points) == 4
    for H in lines:
        steps = np.diff(H)
        assert np.abs(np.angle(steps[1:] / steps[:-1])).max() < 0.1         # were 0.4: seen as a polygon
    assert all(min(np.abs(H - point).min() for H in lines) == 0 for point in points)


@pytest.mark.sweep
@pytest.mark.parametrize("path", FILES, ids=lambda path: path.stem)
def test_numbers_or_a_refusal(path):
    outcomes = []
    for problem in problems_of(path):
        for ask in (text, in_time, over_frequency):
            try:
                ask(problem)
                outcomes.append(None)
            except PhysicsError as error:
                assert error.message and not NO_NUMBER.findall(error.message)
                outcomes.append(error.message)
    assert outcomes
