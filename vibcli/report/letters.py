"""Frequencies, damping and mode shapes in letters, as lines of text."""

from vibcli.algebra.expression import reachable
from vibcli.algebra.grouping import letters
from vibcli.algebra.rationals import ONE
from vibcli.report.notation import plain

LONGEST = 100           # letters of an expression, above which it is not read
OMEGA = "ω"
MARK = "\ue000"        # stands for the root while the rest is written
LONG = "(an expression too long to read; see --json)"
NONE = "no closed form that is readable; give the parameters values with --set"


def frequency_lines(problem, forms):
    """Lines of the section of natural frequencies."""
    if forms is None:
        return [NONE, *_damped_in_numbers(problem, forms)]
    lines = _mode_lines(forms)
    if forms.polynomials:
        lines.append("λ = ω² of the others are the roots of" if forms.modes else "λ = ω² are the roots of")
        lines += [f"{_polynomial(coefficients)} = 0" for coefficients in forms.polynomials]
    elif len(forms.modes) > 1:
        lines.append("(numbered as at sample values of the letters; f = ω/(2π), T = 2π/ω)")
    elif not forms.modes[0].unstable:
        lines.append("f = ω/(2π), T = 2π/ω")
    return lines + _damped_in_numbers(problem, forms)


def _damped_in_numbers(problem, forms):
    if not problem.matrices_in_letters[1] or (forms and any(mode.zeta is not None for mode in forms.modes)):
        return []
    return ["the damped modes are found in numbers only; give the parameters values with --set"]


def _mode_lines(forms):
    """ω₂ = ω₃ = …; the two roots of a long quadratic equation in one line."""
    lines, done = [], set()
    for mode in forms.modes:
        if mode.index in done:
            continue
        same = [other for other in forms.modes if other.omega is mode.omega and other.unstable is mode.unstable]
        twin = [other for other in forms.modes if mode.pair is not None and other.pair is mode.pair]
        both = _both(twin) if len(twin) == 2 else None
        done |= {other.index for other in (twin if both else same)}
        if both:
            lines.append(f"{','.join(_sub(other.index) for other in twin)}".join(("ω", f"² = {both}")))
        elif mode.unstable:
            lines.append(f"mode {mode.index} is unstable: it grows as exp(s·t), s = {plain(mode.omega)}")
        else:
            names = "".join(f"ω{_sub(other.index)} = " for other in same)
            lines.append(names + (plain(mode.omega) if letters(mode.omega) <= LONGEST else LONG))
    return lines


def _both(twin):
    """(B ∓ √D)/A of the two roots of a quadratic equation with letters under the root; else None."""
    pair = twin[0].pair
    if not pair.in_letters:
        return None
    mark = pair.inside.table.parameter(MARK, positive=False)
    node = pair.both(mark)
    text = plain(node)
    if letters(node) + letters(pair.root) > LONGEST or text.count(f" + {mark.name}") != 1:
        return None
    return text.replace(f" + {mark.name}", f" ∓ {plain(pair.root)}")


def equilibrium_lines(values):
    """Lines of an equilibrium in letters, with what the letters must fulfil for it."""
    limits = [limit for node in values.values() for part in reachable([node]) if (limit := _limit(part))]
    where = f"   (where {', '.join(dict.fromkeys(limits))})" if limits else ""
    return [", ".join(f"{plain.symbol(name)} = {plain(node)}" for name, node in values.items()) + where]


def _limit(part):
    """A < B of acos(A/B) and asin(A/B)."""
    if part.op != "call" or part.name not in ("acos", "asin") or part.args[0].op != "product":
        return None
    table, u = part.table, part.args[0]
    above = [(table.number(abs(u.coefficient.numerator)), ONE), *((base, e) for base, e in u.args if e > 0)]
    below = [(table.number(u.coefficient.denominator), ONE), *((base, -e) for base, e in u.args if e < 0)]
    return f"{plain(table.product(*above))} < {plain(table.product(*below))}"


def _polynomial(coefficients):
    """Σ c λ^i with the highest power first."""
    symbol = coefficients[0].table.variable("λ")
    parts = []
    for i, c in zip(range(len(coefficients) - 1, -1, -1), coefficients, strict=True):
        if not c.is_zero:
            text = plain(c * symbol ** i if i else c)
            parts.append((text.startswith("−"), text.removeprefix("−")))
    text = ("−" if parts[0][0] else "") + parts[0][1]
    return text + "".join((" − " if negative else " + ") + part for negative, part in parts[1:])


def damping_lines(forms):
    """Lines of the section of damping."""
    damped = [mode for mode in forms.modes if mode.zeta is not None]
    if not damped:
        return []
    if len(forms.modes) > 1:
        lines, done = [], set()
        for mode in damped:
            same = [other for other in damped if mode.zeta_pattern and other.zeta_pattern is mode.zeta_pattern]
            if mode.index not in done:
                text = plain(mode.zeta_pattern) + _with_omega(same) if same else plain(mode.zeta)
                lines.append("".join(f"ζ{_sub(other.index)}, " for other in same or [mode])[:-2] + " = " + text)
            done |= {other.index for other in same}
        return [*lines, "the modes are those without damping; ω_d = ω·√(1 − ζ²), decay δ = ζ·ω"]
    mode, = damped
    lines = [f"ζ = {plain(mode.zeta)}", f"ω_d = ω·√(1 − ζ²) = {plain(mode.omega_d)}  for ζ < 1", "decay δ = ζ·ω"]
    if forms.critical is not None:
        letter, value = forms.critical
        lines.append(f"critical damping, ζ = 1:  {plain(letter)} = {plain(value)}; over-damped where it is larger")
    return lines


def shape_lines(names, forms):
    """Lines of the section of mode shapes."""
    lines, done = [], set()
    for mode in forms.modes:
        same = [other for other in forms.modes if mode.pattern and other.pattern == mode.pattern]
        same = same if len(same) > 1 or not mode.pattern else [mode]
        if mode.index in done or not (same or mode.readable):
            continue
        done |= {other.index for other in same}
        shape = [_turned(value) if mode.turns and i else plain(value)
                 for i, value in enumerate(mode.pattern or mode.shape)]
        numbers = ", ".join(str(other.index) for other in same or [mode])
        where = _with_omega(same) if any(OMEGA in _names(value) for value in mode.pattern or ()) else ""
        lines.append(f"mode{'s' * (len(same) > 1)} {numbers}:  " + ",  ".join(
            f"{plain.symbol(name)} = {text}" for name, text in zip(names, shape, strict=True)) + where)
    return lines or [NONE]


def _turned(value):
    """i times an amplitude: a quarter period ahead."""
    negative = value.op != "sum" and value.coefficient < 0
    text = plain.write(-value if negative else value, 1)
    return "−" * negative + ("i" if text == "1" else f"i·{text}")


def _with_omega(modes):
    return "   with ω = " + ", ".join(f"ω{_sub(mode.index)}" for mode in modes)


def _names(node):
    return {part.name for part in reachable([node]) if part.op == "symbol"}


def _sub(number):
    return str(number).translate(str.maketrans("0123456789", "₀₁₂₃₄₅₆₇₈₉"))
