"""Printing the results of one file: as a report in some format, or as one JSON document."""

import json

import click

from vibcli.base.errors import Inertless, Kinked, NotInLetters, PhysicsError, Unknown
from vibcli.cli.common import require_quick, show_refusal, show_timings
from vibcli.cli.reports import write_documents, write_text
from vibcli.quantities.quantity import INSIGHT, RESPONSES
from vibcli.report.blocks import Document, Refusal, paragraph, section
from vibcli.report.document import Report, title_of
from vibcli.report.formats.text import render

FLOAT_DIGITS = 12
SLOPES = ("frequencies", "modes", "damping", *INSIGHT)         # what needs a slope of the forces


def print_scenes(problems, sections, output, timings, digits=None, normalise="first", data=(), question=False,
                 wanted=None, curves=None):
    """Print the scene and its cases, or write them; `sections(problem)` names the sections of the report, `data` the
    parts of the JSON; `curves(problem)` plots and saves what belongs to each.

    A case that cannot be solved is refused on stderr and leaves the others: exit code 4.
    """
    for _, problem in problems:
        require_quick(problem, digits)
    found, solved, refused = {}, [], False
    for case, problem in problems:
        try:
            if problem.spec.choices:
                problem = _settled(problem, question, digits)
            solved.append((case, problem))
            if output.kind == "json":
                found[case] = _data(problem, data, normalise, digits, sections(problem), wanted)
                refused |= _told_unknown(problem, case, found[case], wanted)
            else:
                report = _report(problem, _illustrated(sections(problem), output), normalise, digits, output.pictures,
                                 wanted)
                found[case] = report.document(case, question)
                _print_at_once(found, case, output)
                if report.refusal and not isinstance(report.refusal, Unknown):
                    raise report.refusal
            if curves:
                curves(problem)
            if output.kind != "json" and report.refusal:
                raise report.refusal
        except PhysicsError as error:
            if output.kind == "json" and len(problems) == 1:
                raise
            refused = True
            show_refusal(error, problem.spec.file + (f", case {case}" if case else ""))
            found[case] = ({"error": error.message} if output.kind == "json" else
                           _refused(found.get(case), problem.spec, case, error))
    if output.kind == "json":
        _print_json(found, output)
    elif not _at_once(output):
        write_documents(list(found.values()), output)
    if timings:
        show_timings(solved)
    return 4 if refused else 0


def _told_unknown(problem, case, data, wanted):
    """Is a part of the motion not known? Then it is said on stderr too."""
    if not (data.get("response") or {}).get("unknown"):
        return False
    from vibcli.report.sections.response_data import unknown
    from vibcli.report.wanted import Wanted

    show_refusal(unknown(problem, wanted or Wanted()), problem.spec.file + (f", case {case}" if case else ""))
    return True


def _at_once(output):
    """Is each case printed as soon as it is solved?"""
    return output.kind == "text" and output.path is None


def _print_at_once(found, case, output):
    if _at_once(output):
        click.echo(("\n\n" if len(found) > 1 else "") + render([found[case]]))


def _refused(document, spec, case, error):
    """The document of what was found, or an empty one, with the refusal."""
    document = document or Document(title_of(spec, case), None, (), ())
    return document._replace(refusal=Refusal(error.message, error.hint))


def _illustrated(sections, output):
    """The sections, with pictures of the scene and of its modes where they are asked for."""
    if not output.pictures:
        return sections
    return ["schematic", *(part for name in sections
                           for part in ((name, "mode_pictures") if name == "modes" else (name,)))]


def _settled(problem, thorough, digits):
    """The problem with what it chooses, known in closed form where more digits are asked for."""
    from vibcli.inverse import settled

    found = settled(problem, thorough)
    if digits is not None and digits > FLOAT_DIGITS and not found.chosen.exact:
        raise PhysicsError(f"--digits {digits} needs a closed form of what is chosen, and none was found",
                           f"ask for at most {FLOAT_DIGITS} digits")
    return found


def _print_json(found, output):
    first, *cases = found
    if cases:
        found[first]["cases"] = {case: found[case] for case in cases}
    write_text(json.dumps(found[first], ensure_ascii=False, allow_nan=False, indent=1), output)


def _data(problem, parts, normalise, digits, sections, wanted=None):
    from vibcli.report.sections.data import energies_data, equations_data, matrices_data, sticking_data

    if digits is not None:
        _require_numbers(problem)
    found = {"title": problem.spec.get("title"), "coordinates": list(problem.scene.coordinates)}
    if problem.chosen is not None:
        from vibcli.report.sections.design_parameters import chosen_data

        found["chosen"] = chosen_data(problem)
    if "frequencies" in parts:
        found |= _frequencies(problem, parts, normalise, digits, sections)
    if "equilibria" in sections:
        from vibcli.report.sections.equilibria import equilibria_data

        found |= equilibria_data(problem)
    if "equations" in parts:
        refusal = problem.equations.refusal
        if refusal and not (isinstance(refusal, NotInLetters) or _without_slope(problem, refusal, sections)
                            or _listed_alone(problem, sections)):
            raise refusal
        if problem.sticking is not None:
            found["sticking"] = sticking_data(problem)
        found["energies"] = energies_data(problem)
        found["equations"] = equations_data(problem)
        if "frequencies" not in parts:
            known = not refusal or isinstance(refusal, NotInLetters)
            found["matrices"] = matrices_data(problem) if known else None
    if asked := [word for word in sections if word in RESPONSES]:
        from vibcli.report.sections import response_data
        from vibcli.report.wanted import Wanted

        for word in asked:
            beside = word not in parts and problem.symbolic     # of letters `find` asks formulas, which texts have
            found[word] = None if beside else getattr(response_data, word + "_data")(problem, wanted or Wanted())
    if words := [word for word in sections if word in INSIGHT]:
        found["insight"] = _insight(problem, words, sections)
    return found


def _insight(problem, words, sections):
    from vibcli.report.sections.insight_data import insight_data

    try:
        return insight_data(problem, words)
    except PhysicsError as error:
        if not _without_slope(problem, error, sections):
            raise
        return None


def _frequencies(problem, parts, normalise, digits, sections):
    """Equilibrium, matrices and modes; null with a remark where the other parts stand without them."""
    from vibcli.report.sections.data import equilibrium_data, frequencies_data, matrices_data

    try:
        return frequencies_data(problem, normalise, digits)
    except PhysicsError as error:
        letters = isinstance(error, NotInLetters) and "equations" in parts
        if not (letters or _without_slope(problem, error, sections) or _listed_alone(problem, sections)):
            raise
        found = dict.fromkeys(("equilibrium", "matrices", "modes", "damped")) | {"remark": error.message}
        if isinstance(error, Inertless):
            found |= {"equilibrium": equilibrium_data(problem), "matrices": matrices_data(problem)}
        return found


def _without_slope(problem, refusal, sections):
    """Is there no slope, for friction or a kink, or no inertia, where nothing that needs them is asked by name?"""
    if not isinstance(refusal, (Kinked, Inertless)) and problem.sticking is None:
        return False
    asked = problem.spec.get("find") or ()
    beside = "equations" in sections or "frequencies" not in sections
    return beside and not any(word in sections and word in asked for word in SLOPES)


def _listed_alone(problem, sections):
    """Is a list of all equilibria asked, and nothing about the one that is reached from the drawn position?"""
    asked = problem.spec.get("find") or ()
    return "equilibria" in sections and not any(word in asked for word in ("equilibrium", "equations", *SLOPES))


def _report(problem, sections, normalise, digits, pictures, wanted=None):
    report, beside = Report(problem, normalise, pictures, wanted), None
    for name in sections:
        report.add(name)
        if name not in RESPONSES and report.refusal and _without_slope(problem, report.refusal, sections):
            beside, report.refusal = beside or report.refusal, None     # it is said beside the equations
    if isinstance(report.refusal, NotInLetters) and "equations" in sections:
        remark = paragraph(f"{report.refusal.message}: {report.refusal.hint}", hang=0)
        report.sections += section("Not found in letters", remark)
        report.refusal = None
    if isinstance(beside, Inertless):
        report.sections += section("Natural frequencies", paragraph("none: nothing in the scene has inertia", hang=0))
    if digits is not None:
        _digits(report, problem, digits)
    return report


def _digits(report, problem, digits):
    from vibcli.report.sections.data import frequencies_data

    _require_numbers(problem)
    found = frequencies_data(problem, digits=digits)
    lines = []
    for mode in found["modes"]:
        values = [f"ω = {mode['omega']} rad/s"] if mode["omega"] is not None else []
        values += [f"growth rate {mode['growth_rate']} 1/s"] if mode["growth_rate"] is not None else []
        lines.append(f"mode {mode['index']}:  {', '.join(values)}")
    for mode in found["damped"] or ():
        lines.append(f"damped mode {mode['index']}:  λ = {mode['eigenvalue'][0]} {_signed(mode['eigenvalue'][1])} i")
    report.sections += section(f"With {digits} digits", *(paragraph(line, hang=None) for line in lines))


def _require_numbers(problem):
    if problem.symbolic:
        raise PhysicsError("--digits needs numbers, and this scene has symbols without value", "give them with --set")


def _signed(text):
    return "− " + text[1:] if text.startswith("-") else "+ " + text
