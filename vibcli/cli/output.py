"""Printing the results of one file: as text section by section, or as one JSON document."""

import json

import click

from vibcli.cli.common import require_quick, show_timings


def print_scenes(problems, sections, as_json, timings, digits=None, normalise="first", data=()):
    """Print the scene and its cases; `sections(problem)` names the text sections, `data` the parts of the JSON."""
    for _, problem in problems:
        require_quick(problem, digits)
    if as_json:
        whole, *cases = [_data(problem, data, normalise, digits) for _, problem in problems]
        if cases:
            whole["cases"] = {name: found for (name, _), found in zip(problems[1:], cases, strict=True)}
        click.echo(json.dumps(whole, ensure_ascii=False, allow_nan=False, indent=1))
    else:
        texts = [_text(case, problem, sections(problem), normalise, digits) for case, problem in problems]
        click.echo("\n\n".join(texts))
    if timings:
        show_timings(problems)


def _data(problem, parts, normalise, digits):
    from vibcli.report.results import equations_data, frequencies_data, matrices_data

    found = {"title": problem.spec.get("title"), "coordinates": list(problem.scene.coordinates)}
    if "frequencies" in parts:
        found |= frequencies_data(problem, normalise, digits)
    if "equations" in parts:
        found["equations"] = equations_data(problem)
        if "frequencies" not in parts:
            found["matrices"] = matrices_data(problem)
    return found


def _text(case, problem, sections, normalise, digits):
    from vibcli.report.text import Report

    report = Report(problem, normalise)
    report.head(case)
    for section in sections:
        report.add(section)
    if digits is not None:
        _digits(report, problem, digits)
    return report.text()


def _digits(report, problem, digits):
    from vibcli.errors import PhysicsError
    from vibcli.report.results import frequencies_data

    if problem.symbolic:
        raise PhysicsError("--digits needs numbers, and this scene has symbols without value", "give them with --set")
    found = frequencies_data(problem, digits=digits)
    lines = []
    for mode in found["modes"]:
        value = f"ω = {mode['omega']} rad/s" if mode["omega"] is not None else f"growth rate {mode['growth_rate']} 1/s"
        lines.append(f"mode {mode['index']}:  {value}")
    for mode in found["damped"] or ():
        lines.append(f"damped mode {mode['index']}:  λ = {mode['eigenvalue'][0]} {_signed(mode['eigenvalue'][1])} i")
    report.section(f"With {digits} digits", lines)


def _signed(text):
    return "− " + text[1:] if text.startswith("-") else "+ " + text
