"""How constraints tie coordinates, the virtual work of what acts, and the reactions, as lines of a report."""

from vibcli.report.abbreviate import abbreviated
from vibcli.report.brevity import short
from vibcli.report.figures import figure, table, wrapped
from vibcli.report.notation import plain


def tied_lines(scene):
    """How constraints leave the independent coordinates."""
    freedom = scene.freedom
    if not freedom.conditions:
        return []
    closed = [plain.symbol(name) for name in scene.loops.names] if scene.loops else []
    explicit = [f"{plain.symbol(name)} = {short(node)}" for name, node in scene.dependent.items()
                if plain.symbol(name) not in closed]
    lines = wrapped(f"{freedom.coordinates} coordinates less {freedom.conditions} independent condition"
                    f"{'s' if freedom.conditions > 1 else ''}" + (": " if explicit else "") + "   ".join(explicit))
    if closed:
        lines.append(", ".join(closed) + (" follow" if len(closed) > 1 else " follows") + " by closing the loops")
    return lines + [f"'{name}' is redundant: it follows from the other constraints" for name in freedom.redundant]


def virtual_work(problem, roots):
    """(title, lines, lengths that they abbreviate): δA = Σ Q δq, where there are loads or it is asked for."""
    scene = problem.loose
    if not (scene.forces or "virtual_work" in problem.spec.get("find", ())) or not 0 < len(scene.q) <= 16:
        return "", [], []
    from vibcli.mechanics.virtual_work import generalised_forces

    names = [plain.symbol(name) for name in scene.coordinates]
    shown, lengths = abbreviated(scene.table, generalised_forces(scene), roots)
    lines = wrapped("δA = " + " + ".join(f"Q_{name}·δ{name}" for name in names))
    for name, node in zip(names, shown, strict=True):
        rests = scene.constraints or node.is_zero
        lines += wrapped(f"Q_{name} = {short(node)}" + ("" if rests else " = 0"), indent=4)
    driven = ", and of the inertia of driven motion" if scene.timed and scene.inertias else ""
    return f"Virtual work of weights, springs and steady loads{driven}, at rest in equilibrium", lines, lengths


def reaction_sections(problem):
    """(title, lines) of the reactions in equilibrium, of a scene in numbers, and of those along a motion."""
    from vibcli.mechanics.reactions import along_the_motion

    if not problem.symbolic:
        rows = [(reaction.signal, "not fixed by statics" if reaction.value is None else
                 f"{figure(reaction.value)} {'N·m' if reaction.signal.endswith('moment') else 'N'}")
                for reaction in problem.reactions if reaction.value != 0.0]
        yield ("Reactions in equilibrium (tension positive; what supports exert on the body, fixed axes)",
               table(rows, ("force", "value")))
    lines = []
    for signal, node in along_the_motion(problem).items():
        lines += wrapped(f"{signal} = {short(node)}", indent=4)
    yield "Reactions along a motion", lines
