"""Equilibrium, frequencies, damping and mode shapes in letters, as lines of text."""

from vibcli.algebra.expression import reachable
from vibcli.algebra.grouping import letters
from vibcli.algebra.rationals import ONE
from vibcli.report.notation import plain

LONGEST = 100           # letters of an expression, above which it is not read
OMEGA = "ω"
MARK = "𝔇"              # stands under the root while the rest is written
LONG = "(an expression too long to read; see --json)"
NONE = "no closed form that is readable; give the parameters values with --set"
NUMBERED = "(numbered as at sample values of the letters; f = ω/(2π), T = 2π/ω)"


def equilibrium_lines(values):
    """Lines of an equilibrium in letters, with what the letters must fulfil for it."""
    limits = [limit for node in values.values() for part in reachable([node]) if (limit := _limit(part))]
    where = f"   (where {', '.join(dict.fromkeys(limits))})" if limits else ""
    return [", ".join(f"{plain.symbol(name)} = {plain(node)}" for name, node in values.items()) + where]


def _limit(part):
    """A < B of acos(A/B) and asin(A/B), unless A holds a difference."""
    if part.op != "call" or part.name not in ("acos", "asin") or part.args[0].op != "product":
        return None
    table, u = part.table, part.args[0]
    if any(base.op == "sum" and min(c for _, c in base.args) < 0 for base, _ in u.args):
        return None
    above = [(table.number(abs(u.coefficient.numerator)), ONE), *((base, e) for base, e in u.args if e > 0)]
    below = [(table.number(u.coefficient.denominator), ONE), *((base, -e) for base, e in u.args if e < 0)]
    return f"{plain(table.product(*above))} < {plain(table.product(*below))}"


def frequency_lines(problem, forms):
    """Lines of the section of natural frequencies."""
    lines = [NONE]
    if forms is not None:
        lines = _modes(forms.modes)
        if forms.polynomials:
            lines.append("λ = ω² of the others are the roots of" if forms.modes else "λ = ω² are the roots of")
            lines += [_equation(coefficients) for coefficients in forms.polynomials]
        if len(forms.modes) + len(forms.polynomials) > 1:
            lines.append(NUMBERED)
        elif forms.modes and not forms.modes[0].unstable:
            lines.append("f = ω/(2π), T = 2π/ω")
    damped = forms is not None and any(mode.zeta is not None for mode in forms.modes)
    if problem.matrices_in_letters[1] and not damped:
        lines.append("the damped modes are found in numbers only; give the parameters values with --set")
    return lines


def _modes(modes):
    """A line a frequency: equal ones together, and the two roots of a long quadratic equation."""
    lines, done = [], set()
    for mode in modes:
        if mode.index not in done:
            twin = [other for other in modes if mode.pair is not None and other.pair is mode.pair]
            line = _of_two(twin) if len(twin) == 2 else None
            same = [other for other in modes if other.omega is mode.omega and other.unstable is mode.unstable]
            lines.append(line or _of_one(mode, same))
            done |= {other.index for other in (twin if line else same)}
    return lines


def _of_one(mode, same):
    if mode.unstable:
        return f"mode {mode.index} is unstable: it grows as exp(s·t), s = {plain(mode.omega)}"
    text = plain(mode.omega) if letters(mode.omega) <= LONGEST else LONG
    return "".join(f"ω{_sub(other.index)} = " for other in same) + text


def _of_two(twin):
    """ω₁,₂² = (B ∓ √D)/A, or the quadratic equation where that is long; None where D is a number or a root unstable."""
    pair, names = twin[0].pair, [_sub(mode.index) for mode in twin]
    if not pair.in_letters or twin[0].unstable:
        return None
    node = pair.both(pair.root.table.sqrt(pair.root.table.parameter(MARK, positive=False)))
    text = plain(node)
    if letters(node) + letters(pair.root) <= LONGEST and text.count(f" + √{MARK}") == 1:
        return f"ω{','.join(names)}² = " + text.replace(f" + √{MARK}", f" ∓ {plain(pair.root)}")
    if all(letters(mode.omega) <= LONGEST for mode in twin):
        return None
    return f"ω{names[0]}² and ω{names[1]}² are the roots λ of {_polynomial(pair.equation())} = 0"


def _equation(coefficients):
    """A polynomial = 0, or its degree where it is too long to read."""
    if sum(map(letters, coefficients)) > 3 * LONGEST:
        return f"a polynomial of degree {len(coefficients) - 1}, too long to read; see --json"
    return f"{_polynomial(coefficients)} = 0"


def _polynomial(coefficients):
    """Σ c λ^i with the highest power first."""
    symbol, degree = coefficients[0].table.variable("λ"), len(coefficients) - 1
    parts = [plain(c * symbol ** (degree - i) if degree > i else c) for i, c in enumerate(coefficients)
             if not c.is_zero]
    return parts[0] + "".join(f" − {part[1:]}" if part.startswith("−") else f" + {part}" for part in parts[1:])


def damping_lines(forms):
    """Lines of the section of damping."""
    damped = [mode for mode in forms.modes if mode.zeta is not None]
    if not damped:
        return []
    if len(forms.modes) > 1:
        return [*_ratios(damped), "the modes are those without damping; ω_d = ω·√(1 − ζ²), decay δ = ζ·ω"]
    mode, = damped
    lines = [f"ζ = {plain(mode.zeta)}", f"ω_d = ω·√(1 − ζ²) = {plain(mode.omega_d)}  for ζ < 1",
             f"decay δ = ζ·ω = {plain(mode.zeta * mode.omega)}"]
    if forms.critical is not None:
        letter, value = forms.critical
        lines.append(f"critical damping, ζ = 1:  {plain(letter)} = {plain(value)}")
    return [*lines, "over-damped, ζ > 1:  decay rates ω·(ζ ∓ √(ζ² − 1))"]


def _ratios(damped):
    """ζ of each mode, as a function of ω where that is shorter."""
    lines, done = [], set()
    for mode in damped:
        if mode.index not in done:
            same = [other for other in damped if mode.zeta_pattern and other.zeta_pattern is mode.zeta_pattern]
            text = plain(mode.zeta_pattern) + _with(same) if same else plain(mode.zeta)
            lines.append(", ".join(f"ζ{_sub(other.index)}" for other in same or [mode]) + f" = {text}")
            done |= {other.index for other in same}
    return lines


def shape_lines(names, forms):
    """Lines of the section of mode shapes."""
    lines, done = [], set()
    for mode in forms.modes:
        if mode.index in done or not (mode.pattern or mode.readable):
            continue
        same = [other for other in forms.modes if mode.pattern and other.pattern == mode.pattern] or [mode]
        done |= {other.index for other in same}
        shape = mode.pattern or mode.shape
        text = ",  ".join(f"{plain.symbol(name)} = {_turned(value) if mode.turns and i else plain(value)}"
                          for i, (name, value) in enumerate(zip(names, shape, strict=True)))
        numbers = ", ".join(str(other.index) for other in same)
        depends = any(part.name == OMEGA for part in reachable(shape))
        lines.append(f"mode{'s' * (len(same) > 1)} {numbers}:  {text}" + (_with(same) if depends else ""))
    return lines or [NONE]


def _turned(value):
    """i times an amplitude: a quarter period ahead."""
    negative = value.op != "sum" and value.coefficient < 0
    text = plain.write(-value if negative else value, 1)
    return "−" * negative + ("i" if text == "1" else f"i·{text}")


def _with(modes):
    return "   with ω = " + ", ".join(f"ω{_sub(mode.index)}" for mode in modes)


def _sub(number):
    return str(number).translate(str.maketrans("0123456789", "₀₁₂₃₄₅₆₇₈₉"))
