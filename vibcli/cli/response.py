"""`vibcli response FILE`: the motion in time."""

from collections.abc import Mapping, Sequence
from typing import TYPE_CHECKING, Any

import click
from click.core import ParameterSource

from vibcli.cli.common import accuracy_option, chosen, integrated, load, scene_options
from vibcli.cli.output import print_scenes
from vibcli.cli.reports import output_of, report_options
from vibcli.cli.sampled import (
    INSTANT,
    PICTURES,
    asked,
    cases_to_show,
    curve_options,
    refuse_targets,
    require_curves,
    show_curves,
    size,
)

if TYPE_CHECKING:
    from vibcli.report.wanted import Wanted
    from vibcli.results.problem import Problem


@click.command("response")
@scene_options
@report_options
@click.option("--of", "signals", multiple=True, metavar="SIGNAL", help="What of the motion: x, x', s.force, k*x; may "
              "be given several times. The coordinates unless given, here or by `find` of the file.")
@click.option("--until", metavar="TIME", help="Its end, as 2 (seconds) or '500 ms'; unless given, here or by "
              "`find` of the file, some periods, or until it has died out.")
@click.option("--at", "instants", multiple=True, metavar="TIME", help="Also the values at this instant, as 2.5 or "
              "'40 ms'; may be given several times.")
@click.option("--digits", type=click.IntRange(1, 200), metavar="N", help="Those values, and extremes, with N correct "
              "digits, in arbitrary precision.")
@accuracy_option
@click.option("--points", type=click.IntRange(2, 1_000_000), default=1001, show_default=True, metavar="N",
              help="How many instants are plotted or saved.")
@click.option("--phase", type=click.Choice(["sine", "cosine", "lead"]), default="sine", show_default=True,
              help="Steady states as X sin(Ωt − θ), X cos(Ωt − θ) or X sin(Ωt + α).")
@click.option("--phase-plane", "plane", is_flag=True, help="Instead: orbits of one degree of freedom over its place "
              "and speed, with equilibria by their kinds; drawn in the terminal, or as --save and --json say.")
@click.option("--steady", is_flag=True, help="Plot or save the steady part as well.")
@click.option("--transient", is_flag=True, help="Plot or save the transient part as well.")
@curve_options
def command(file: str, settings: Sequence[Any], case: Any, as_json: bool, patience: int, timings: bool,
            signals: Sequence[str], until: str | None, instants: Sequence[str], digits: int | None,
            accuracy: float | None, points: int, phase: str, plane: bool, steady: bool, transient: bool, plot: bool,
            saves: Sequence[str], **report: Any) -> int:
    """The motion in time, free or forced: its formula, steady state and extremes; plotted, or saved as numbers.

    It starts as `initial` in the file says, else at rest: vibcli explain response.
    """
    from vibcli.report.wanted import Wanted

    if plane:
        refuse_beside_plane({"--of": signals, "--until": until, "--at": instants, "--digits": digits,
                             "--accuracy": accuracy, "--steady": steady, "--transient": transient})
        return _phase_plane(file, settings, case, as_json, patience, timings, plot, saves, report)
    refuse_targets(saves, report["force"])
    require_curves(plot, saves, as_json, {"--steady": steady, "--transient": transient})
    if digits and accuracy:
        raise click.UsageError("--accuracy does not go with --digits, which ask for more than floats have")
    output = output_of(file, as_json, **report)
    problems = integrated(cases_to_show(chosen(load(file, settings, patience), case), saves), accuracy)
    parts = tuple(word for word, on in (("steady", steady), ("transient", transient)) if on)
    wanted = Wanted(tuple(asked(text, "--of") for text in signals), None, phase, parts=parts, points=points,
                    at=tuple((text, size(text, "--at", "s", INSTANT, exact=True)) for text in instants), digits=digits)
    if until is not None:
        problems = ending(problems, until)
    for _, problem in problems:
        refuse_parts(problem, parts)
    return print_scenes(problems, lambda problem: ("chosen", "response"), output, timings, data=("response",),
                        wanted=wanted, curves=lambda problem: _shown(problem, wanted, plot, saves, report["force"]))


def refuse_beside_plane(options: Mapping[str, Any]) -> None:
    """A usage error where something is asked of a motion in time."""
    for name in ("points", "phase"):
        if click.get_current_context().get_parameter_source(name) is ParameterSource.COMMANDLINE:
            options = {**options, f"--{name}": True}
    idle = next((option for option, given in options.items() if given), None)
    if idle:
        raise click.UsageError(f"{idle} does not go with --phase-plane, which shows no motion in time")


def _phase_plane(file: str, settings: Sequence[str], case: str | None, as_json: bool, patience: int, timings: bool,
                 plot: bool, saves: Sequence[str], report: Mapping[str, Any]) -> int:
    """In the terminal where nothing else is asked for."""
    refuse_targets(saves, report["force"], PICTURES)
    if plot and as_json:
        raise click.UsageError("--plot does not go with --json: save the picture with --save FILE")
    output = output_of(file, as_json, **report)
    plot = plot or not (saves or as_json or output.path or output.kind != "text")
    problems = cases_to_show(chosen(load(file, settings, patience), case), saves)
    return print_scenes(problems, lambda problem: ("chosen", "phase_plane"), output, timings,
                        curves=lambda problem: _plane_shown(problem, plot, saves, report["force"]))


def _plane_shown(problem: "Problem", plot: bool, saves: Sequence[str], force: bool) -> None:
    if not (plot or saves):
        return
    from vibcli.report.sections.phase_plane import plane_figure

    figure = plane_figure(problem)
    show_curves(plot, saves, force, problem.spec.get("title") or "", lambda: figure)


def refuse_parts(problem: "Problem", parts: Sequence[str]) -> None:
    """PhysicsError, before anything is integrated, where a motion has no such parts."""
    from vibcli.base.errors import PhysicsError

    if parts and problem.spec.in_full:
        raise PhysicsError(f"a motion that is integrated has no {parts[0]} part that is found",
                           f"leave --{parts[0]} out")


def ending(problems: "Sequence[tuple[Any, Problem]]", text: str) -> "list[tuple[Any, Problem]]":
    """The same with motions that end as given; a usage error where that is no time."""
    end = size(text, "--until", "s", "a time, as in 2 or '500 ms'")
    return [(case, problem.until(end)) for case, problem in problems]


def _shown(problem: "Problem", wanted: "Wanted", plot: bool, saves: Sequence[str], force: bool) -> None:
    if not (plot or saves):
        return
    from vibcli.report.sections.sampled_series import columns, response_figure, sampled

    series = sampled(problem, wanted)
    show_curves(plot, saves, force, problem.response.title, lambda: response_figure(problem, series),
                lambda: columns(problem, series))
