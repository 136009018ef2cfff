"""What is found about a problem, as a Report of sections or as data with the keys of --json."""

from collections.abc import Sequence
from importlib import import_module
from typing import TYPE_CHECKING, Any

from vibcli.base.errors import Inertless, Kinked, NoEquilibrium, NotInLetters, PhysicsError
from vibcli.reader.sections.find import INSIGHT, MODES, OF_MODES, ON_REQUEST, RESPONSES
from vibcli.report.blocks import paragraph, section
from vibcli.report.document import EVERYTHING, Report
from vibcli.report.wanted import Wanted

if TYPE_CHECKING:
    from vibcli.language.spec import Spec
    from vibcli.results.problem import Problem

PICTURES = {"equilibrium": "force_diagrams", "modes": "mode_pictures"}
STATICS = ("given", "chosen", "coordinates", "reactions")       # of a scene without freedom
PRESCRIBED = ("given", "chosen", "coordinates", "energies", "equations", "prescribed")    # of what is driven alone
SLOPES = ("frequencies", "modes", "damping", *OF_MODES)       # what needs a slope of the forces
OF_ONE_KEY = ("equivalents", "backbone", "expansion", "phase_plane", "steps")       # sections that give their own key
FOUND_BY = {"equations": ("energies", "equations", "frequency_equation"), "energies": ("energies",),
            "matrices": ("matrices",),
            "equilibrium": ("equilibrium", "virtual_work"), "frequencies": ("frequencies",), "modes": ("modes",),
            "damping": ("damping",), "accelerations": ("accelerations",),
            "virtual_work": ("virtual_work",)} | {word: (word,) for word in ON_REQUEST}


def solution(problem: "Problem", insight: bool = False) -> Sequence[str]:
    """The sections of the solution of a scene: all that is cheap, or what its `find` asks for."""
    wanted, beside = problem.spec.get("find"), ("equivalents",) * _asks_equivalents(problem.spec)
    if wanted is None and problem.scene.held:
        return STATICS
    if wanted is None and _is_prescribed(problem):
        return PRESCRIBED
    if wanted is None:
        return EVERYTHING + beside + INSIGHT * insight
    asked = {"given", "chosen", "coordinates", *beside, *INSIGHT * insight}
    asked |= {s for word in wanted for s in FOUND_BY[word]}
    if wanted.about(MODES) is not None:
        asked |= {"frequencies", "damping", "modes"}
    of_motion = {*FOUND_BY["equations"], *FOUND_BY["equilibrium"]}
    if problem.scene.held and asked & of_motion:
        asked = asked - of_motion | set(STATICS)
    return [s for s in EVERYTHING + ON_REQUEST if s in asked]


def _is_prescribed(problem: "Problem") -> bool:
    """Does nothing move freely, and do answers ask for the motion in time?"""
    return not problem.scene.q and not problem.scene.pieces and any(
        tree.args for answer in problem.spec.answers for tree in answer.asked.parts.quantities)


def _asks_equivalents(spec: "Spec") -> bool:
    """Do answers ask for what springs or dampers at one place resist with?"""
    return any(tree.head in ("stiffness", "damping") and tree.component
               for answer in spec.answers for tree in answer.asked.parts.quantities)


STEPS = ("given", "chosen", "steps")        # of a worked solution


def derivation(problem: "Problem") -> Sequence[str]:
    """The sections of the energies and equations of motion; of the conditions of equilibrium where nothing moves."""
    return STATICS[1:] if problem.scene.held else ("chosen", "coordinates", "energies", "equations", "accelerations")


def illustrated(sections: Sequence[str]) -> list[str]:
    """The sections, with pictures of the scene, of the forces within its members and of its modes."""
    return ["schematic", *(part for name in sections
                           for part in ((name, PICTURES[name]) if name in PICTURES else (name,)))]


def data(problem: "Problem", parts: Sequence[str], normalise: str, digits: int | None, sections: Sequence[str],
         wanted: Wanted | None = None) -> dict[str, object]:
    """The results with the keys of --json: those of its `parts`, and what is asked for among the sections; with what
    certifies them."""
    from vibcli.report.sections.certified import certified

    return _parts(problem, parts, normalise, digits, sections, wanted) | certified(problem)


def _parts(problem: "Problem", parts: Sequence[str], normalise: str, digits: int | None, sections: Sequence[str],
           wanted: Wanted) -> dict[str, Any]:
    from vibcli.report import keys

    if digits is not None:
        _require_numbers(problem)
    found: dict[str, Any] = {"title": problem.spec.get("title"), "coordinates": list(problem.scene.coordinates)}
    if "prescribed" in sections:
        parts = tuple(part for part in parts if part == "equations")
    if problem.choice is not None:
        from vibcli.report.sections.design_parameters import CHOSEN

        found |= keys.data([CHOSEN], problem)
    if problem.scene.held and not set(sections).intersection(SLOPES):
        from vibcli.report.sections.statics import REACTIONS

        return found | keys.data([REACTIONS], problem)
    if "frequencies" in parts:
        found |= _frequencies(problem, parts, normalise, digits, sections, wanted)
    if "equilibria" in sections:
        from vibcli.report.sections.equilibria import EQUILIBRIA, SEARCH

        found |= keys.data([EQUILIBRIA, SEARCH], problem)
    if "equations" in parts:
        found |= _equations(problem, parts, sections)
    if "accelerations" in sections:
        from vibcli.report.sections.accelerations import ACCELERATIONS, falls

        if "accelerations" in problem.spec.get("find", ()) or falls(problem):
            found |= keys.data([ACCELERATIONS], problem)
    found |= {word: _responses(problem, word, parts, wanted) for word in sections if word in RESPONSES}
    found |= keys.data([import_module(f"vibcli.report.sections.{word}").KEY
                        for word in OF_ONE_KEY if word in sections], problem)
    if "sweep" in sections:
        from vibcli.report.sections.sweep import KEY, sweep_data

        return found | {KEY.name: sweep_data(wanted.sweep)}
    if "variants" in sections:
        from vibcli.report.sections import variants

        return found | {variants.KEY.name: variants.variants_data(wanted.variants)}
    if words := [word for word in sections if word in OF_MODES]:
        found["insight"] = _insight(problem, words, sections)
    return found


def _equations(problem: "Problem", parts: Sequence[str], sections: Sequence[str]) -> dict[str, Any]:
    """Energies, equations of motion and matrices in letters where they are known; null each along members."""
    from vibcli.report import keys

    if problem.scene.pieces:       # they are differential equations along members
        return dict.fromkeys(("energies", "equations", "matrices"))
    refusal = problem.symbolic.equations.refusal
    if refusal and not (isinstance(refusal, NotInLetters) or _without_slope(problem, refusal, sections)
                        or _listed_alone(problem, sections)):
        raise refusal
    from vibcli.report.sections.equations_of_motion import ENERGY, EQUATIONS, MATRICES
    from vibcli.report.sections.equilibrium import STICKING

    found = keys.data([*[STICKING] * (problem.system.sticking is not None), ENERGY, EQUATIONS], problem)
    if "frequencies" in parts:
        return found
    known = not refusal or isinstance(refusal, NotInLetters)
    return found | (keys.data([MATRICES], problem) if known else {"matrices": None})


def _responses(problem: "Problem", word: str, parts: Sequence[str], wanted: Wanted) -> Any:
    """Motions in time or frequency responses; null of letters, of which `find` asks formulas, which texts have."""
    from vibcli.report.sections import frequency_response, motion_data

    if word not in parts and problem.numeric.has_free_symbols:
        return None
    write = motion_data.response_data if word == "response" else frequency_response.frequency_response_data
    return write(problem, wanted or Wanted())


def _insight(problem: "Problem", words: Sequence[str], sections: Sequence[str]) -> dict[str, Any] | None:
    from vibcli.report import keys
    from vibcli.report.section_keys import section_keys
    from vibcli.report.sections.insight import require_numbers

    try:
        for word in words:
            require_numbers(problem, word)
        return keys.data(section_keys(words), problem)
    except PhysicsError as error:
        if not _without_slope(problem, error, sections):
            raise
        return None


def _frequencies(problem: "Problem", parts: Sequence[str], normalise: str, digits: int | None, sections: Sequence[str],
                 wanted: Wanted) -> dict[str, Any]:
    """Equilibrium, matrices and modes; null with a remark where the other parts stand without them."""
    from vibcli.report import keys
    from vibcli.report.sections.spectrum_data import frequencies_data

    try:
        return frequencies_data(problem, normalise, digits, wanted)
    except PhysicsError as error:
        letters = isinstance(error, NotInLetters) and "equations" in parts
        if not (letters or _without_slope(problem, error, sections) or _listed_alone(problem, sections)):
            raise
        found = dict.fromkeys(("equilibrium", "matrices", "modes", "damped")) | {"remark": error.message}
        if isinstance(error, Inertless):
            from vibcli.report.sections.equations_of_motion import MATRICES
            from vibcli.report.sections.equilibrium import EQUILIBRIUM

            found |= keys.data([EQUILIBRIUM, MATRICES], problem)
        elif _rests_at_a_jump(problem, error):
            from vibcli.report.sections.equilibrium import EQUILIBRIUM

            found |= keys.data([EQUILIBRIUM], problem)
        return found


def _rests_at_a_jump(problem: "Problem", error: PhysicsError) -> bool:
    return isinstance(error, Kinked) and not problem.numeric.has_free_symbols and bool(
        problem.configuration.equilibrium.jumps)


def _without_slope(problem: "Problem", refusal: PhysicsError, sections: Sequence[str]) -> bool:
    """Is there no slope, for friction or a kink, or no inertia, where nothing that needs them is asked by name?"""
    if "prescribed" in sections:
        return True
    if not isinstance(refusal, (Kinked, Inertless, NoEquilibrium)) and problem.system.sticking is None:
        return False
    asked = problem.spec.get("find") or ()
    if isinstance(refusal, NoEquilibrium) and "equilibrium" in asked:
        return False
    beside = "equations" in sections or "frequencies" not in sections
    return beside and not any(word in sections and word in asked for word in SLOPES)


def _listed_alone(problem: "Problem", sections: Sequence[str]) -> bool:
    """Is a list of all equilibria asked, and nothing about the one that is reached from the drawn position?"""
    asked = problem.spec.get("find") or ()
    return "equilibria" in sections and not any(word in asked for word in ("equilibrium", "equations", *SLOPES))


def report(problem: "Problem", sections: Sequence[str], normalise: str = "first", digits: int | None = None,
           pictures: bool = False, wanted: Wanted | None = None) -> Report:
    """The Report of a problem with these sections; its refusal, where something that is asked for is not found."""
    made, beside = Report(problem, normalise, pictures, wanted), None
    for name in sections:
        made.add(name)
        if name not in RESPONSES and made.refusal and _without_slope(problem, made.refusal, sections):
            refusal = made.without_refusal()        # it is said beside the equations
            beside = beside or refusal
    if isinstance(made.refusal, NotInLetters) and "equations" in sections:
        refusal = made.without_refusal()
        made.append(section("Not found in letters", paragraph(f"{refusal.message}: {refusal.hint}", hang=0)))
    if isinstance(beside, NoEquilibrium):
        made.append(section("Equilibrium", paragraph(beside.message.replace("no equilibrium", "none", 1), hang=0)))
    if isinstance(beside, Kinked) and "equilibrium" in sections and "equations" not in sections:
        made.append(section("Equilibrium", paragraph(beside.message, hang=0)))
    if isinstance(beside, Inertless):
        made.append(section("Natural frequencies", paragraph("none: nothing in the scene has inertia", hang=0)))
    if digits is not None:
        _digits(made, problem, digits)
    return made


def require_certified(problem: "Problem", sections: Sequence[str], normalise: str = "first", digits: int | None = None,
                      wanted: Wanted | None = None) -> None:
    """PhysicsError where a figure of these sections has fewer digits than others, or what is found leaves more than
    rounding behind; or the refusal of one of them."""
    from vibcli.report.sections.certified import require_all_digits, require_rounding

    made = report(problem, sections, normalise, digits, wanted=wanted)
    if made.refusal:
        raise made.refusal
    require_all_digits(made.sections)
    require_rounding(problem)


def _digits(made: Report, problem: "Problem", digits: int | None) -> None:
    from vibcli.report.sections.spectrum_data import frequencies_data

    _require_numbers(problem)
    found = frequencies_data(problem, digits=digits, wanted=made.wanted)
    lines = []
    for mode in found["modes"]:
        values = [f"ω = {mode['omega']} rad/s"] if mode["omega"] is not None else []
        values += [f"growth rate {mode['growth_rate']} 1/s"] if mode["growth_rate"] is not None else []
        lines.append(f"mode {mode['index']}:  {', '.join(values)}")
    for mode in found["damped"] or ():
        lines.append(f"damped mode {mode['index']}:  λ = {mode['eigenvalue'][0]} {_signed(mode['eigenvalue'][1])} i")
    made.append(section(f"With {digits} digits", *(paragraph(line, hang=None) for line in lines)))


def _require_numbers(problem: "Problem") -> None:
    if problem.numeric.has_free_symbols:
        from vibcli.language.parameters import require_values

        require_values(problem.scene.parameters, "--digits")


def _signed(text: str) -> str:
    return "− " + text[1:] if text.startswith("-") else "+ " + text
