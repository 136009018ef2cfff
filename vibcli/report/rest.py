"""The equilibrium that is reached from the drawn position."""

from vibcli.report.blocks import Name, Words, equations, line, maths, paragraph, section, separated
from vibcli.report.figures import figure, quantity


def equilibrium(problem, _):
    blocks = _in_letters(problem) if problem.symbolic else _in_numbers(problem)
    preloads = equations(line(Words(f"static preload of {name}: "), *_preload(problem, node, name), hang=None)
                         for name, node in problem.preloads.items())
    slack = [] if problem.symbolic else _slack(problem)
    yield from section("Equilibrium", *blocks, preloads, *slack)


def _in_numbers(problem):
    from vibcli.analyses.stability import WORDS, stability
    from vibcli.report.equilibria import equilibrium_warning

    found = problem.equilibrium
    values = [*found.values.items(),
              *((name, value) for name, value in problem.dependent_values.items() if name not in found.values)]
    stable = WORDS[stability(problem).kind]
    told = separated(maths(Name(name), " = ", *measured(value, problem.dimension(name))) for name, value in values)
    where = "the drawn position" if found.drawn else "shifted from the drawn position"
    warning = equilibrium_warning(problem)
    return [paragraph(*told, f"   ({where})"), _from_start(problem),
            paragraph(f"{stable}; residual {figure(found.residual, digits=2)} of the forces", hang=None),
            paragraph(warning) if warning else None]


def _from_start(problem):
    """How far an equilibrium lies from the start that `equilibrium:` names, None where it names none."""
    found = problem.equilibrium
    if found.start is None:
        return None
    def told(values, sign=""):
        return separated(maths(Name(sign + name), " = ", *measured(values[name], problem.dimension(name)))
                         for name in problem.scene.coordinates)

    return paragraph("the nearest found to the start ", *told(found.start), ", from there ",
                     *told(found.from_start, "Δ"), hang=None)


def _in_letters(problem):
    from vibcli.mechanics.symbolic import equilibrium_in_letters
    from vibcli.report.letters import equilibrium_parts

    parts = equilibrium_parts(equilibrium_in_letters(problem))
    settled = problem.equilibrium_letters
    drawn = problem.balanced_as_drawn and problem.start_in_letters is None
    searched = settled is not None and problem.start_in_letters is not None and not settled.named
    return [paragraph(*parts, "   (the drawn position)" if drawn else ""),
            paragraph("the nearest to the start at sample values of the letters", hang=None) if searched else None]


def measured(value, dimension):
    """Parts of a number with its unit."""
    number, unit = quantity(value, dimension)
    return number, Words(unit)


def _preload(problem, node, name):
    if problem.symbolic:
        return (node,)
    from vibcli.algebra.evaluate import Floats, evaluate

    unit = "N·m" if "torsion" in problem.spec.get("springs")[name] else "N"
    return node, " = ", figure(evaluate([node], Floats, problem.floats)[0]), Words(f" {unit}")


def _slack(problem):
    """What pushes where only a rope could pull."""
    if not any("rope" in record for record in (problem.spec.get("constraints") or {}).values()):
        return []
    from vibcli.mechanics.reactions import slack

    return [paragraph(f"{signal} = {figure(value)} N would be a push: the rope goes slack", hang=None)
            for signal, value in slack(problem)]
