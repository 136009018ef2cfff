"""Equilibrium, frequencies, damping and mode shapes in letters."""

from collections.abc import Iterator, Mapping, Sequence
from typing import TYPE_CHECKING, Any

from vibcli.base.work import longer
from vibcli.notation.names import lowered
from vibcli.notation.plain import plain
from vibcli.report.blocks import (
    Either,
    Equations,
    Factor,
    Maths,
    Name,
    Paragraph,
    SumOfTerms,
    Words,
    equations,
    line,
    maths,
    paragraph,
    separated,
)
from vibcli.symbolic.expression_graph import reachable
from vibcli.symbolic.nested_form import letters
from vibcli.symbolic.rationals import ONE

if TYPE_CHECKING:
    from vibcli.analyses.closed_form.closed_forms import ClosedForms, ClosedMode
    from vibcli.report.blocks import Line
    from vibcli.results.problem import Problem
    from vibcli.symbolic.node import Node

OMEGA = "ω"
MARK = "𝔇"              # stands under the root while the rest is written
LONG = "(an expression too long to read; see --json)"
NONE = "no closed form that is readable; give the parameters values with --set"
NUMBERED = "(numbered as at sample values of the letters; f = ω/(2π), T = 2π/ω)"


def equilibrium_parts(values: "Mapping[str, Node]") -> tuple[str | Maths, ...]:
    """An equilibrium in letters in running text, with what the letters must fulfil for it."""
    limits = [limit for node in values.values() for part in reachable([node]) if (limit := _limit(part))]
    where = ["   (where ", *separated(maths(*limit) for limit in dict.fromkeys(limits)), ")"] if limits else []
    return *separated(maths(Name(name), " = ", node) for name, node in values.items()), *where


def _limit(part: "Node") -> "tuple[Node, str, Node] | None":
    """Parts of A < B of acos(A/B) and asin(A/B), unless A holds a difference."""
    if part.op != "call" or part.name not in ("acos", "asin") or part.args[0].op != "product":
        return None
    table, u = part.table, part.args[0]
    if any(base.op == "sum" and min(c for _, c in base.args) < 0 for base, _ in u.args):
        return None
    above = [(table.number(abs(u.coefficient.numerator)), ONE), *((base, e) for base, e in u.args if e > 0)]
    below = [(table.number(u.coefficient.denominator), ONE), *((base, -e) for base, e in u.args if e < 0)]
    return table.product(*above), " < ", table.product(*below)


def frequency_blocks(problem: "Problem", forms: "ClosedForms") -> Iterator[Equations | Paragraph]:
    """What the section of natural frequencies says."""
    told = [no_form(problem)]
    if forms is not None:
        told = []
        yield equations(_modes(forms.modes))
        if forms.polynomials:
            yield paragraph(maths("λ = ω²"), " of the others" * bool(forms.modes) + " are the roots of")
            yield equations(map(_equation, forms.polynomials))
        if len(forms.modes) + len(forms.polynomials) > 1:
            told.append(NUMBERED)
        elif forms.modes and not forms.modes[0].unstable:
            yield paragraph(maths("f = ω/(2π)"), ", ", maths("T = 2π/ω"))
    damped = forms is not None and any(mode.zeta is not None for mode in forms.modes)
    if problem.symbolic.matrices[1] and not damped:
        told.append("the damped modes are found in numbers only; give the parameters values with --set")
    yield from (paragraph(text, hang=4) for text in told)


def no_form(problem: "Problem") -> str:
    """That there is no closed form, and whether the search for it was given up."""
    if problem.work.cut:
        return f"no closed form was found before the search was given up; {longer(problem.work)}; or give the " \
            "parameters values with --set"
    return NONE


def _modes(modes: "Sequence[ClosedMode]") -> "Iterator[Line]":
    """A line a frequency: equal ones together, and the two roots of a long quadratic equation."""
    done = set()
    for mode in modes:
        if mode.index not in done:
            twin = [other for other in modes if mode.pair is not None and other.pair is mode.pair]
            both = _of_two(twin) if len(twin) == 2 else None
            same = [other for other in modes if other.omega is mode.omega and other.unstable is mode.unstable]
            yield both or _of_one(mode, same)
            done |= {other.index for other in (twin if both else same)}


def _of_one(mode: "ClosedMode", same: "Sequence[ClosedMode]") -> "Line":
    if mode.unstable:
        return line(Words(f"mode {mode.index} is unstable: it grows as "), "exp(s·t), s = ", mode.omega)
    shown = mode.omega if mode.short else Words(LONG)
    return line("".join(f"ω{lowered(other.index)} = " for other in same), shown)


def _of_two(twin: "Sequence[ClosedMode]") -> "Line | None":
    """ω₁,₂² = (B ∓ √D)/A, or the quadratic equation where that is long; None where D is a number or a root unstable."""
    from vibcli.analyses.closed_form.closed_forms import LONGEST

    pair, names = twin[0].pair, [lowered(mode.index) for mode in twin]
    if not pair.in_letters or twin[0].unstable:
        return None
    mark = pair.root.table.sqrt(pair.root.table.parameter(MARK, positive=False))
    node = pair.both(mark)
    if letters(node) + letters(pair.root) <= LONGEST and plain(node).count(f" + √{MARK}") == 1:
        return line(f"ω{','.join(names)}² = ", Either(node, mark, pair.root))
    if all(mode.short for mode in twin):
        return None
    return line(f"ω{names[0]}²", Words(" and "), f"ω{names[1]}²", Words(" are the roots "), "λ", Words(" of "),
                _polynomial(pair.equation()), " = 0")


def _equation(coefficients: Sequence[Any]) -> "Line":
    """A polynomial = 0, or its degree where it is too long to read."""
    from vibcli.analyses.closed_form.closed_forms import LONGEST

    if sum(map(letters, coefficients)) > 3 * LONGEST:
        return line(Words(f"a polynomial of degree {len(coefficients) - 1}, too long to read; see --json"))
    return line(_polynomial(coefficients), " = 0")


def _polynomial(coefficients: Sequence[Any]) -> SumOfTerms:
    """Σ c λ^i with the highest power first."""
    symbol, degree = coefficients[0].table.variable("λ"), len(coefficients) - 1
    return SumOfTerms(tuple(c * symbol ** (degree - i) if degree > i else c for i, c in enumerate(coefficients)
                       if not c.is_zero))


def damping_blocks(forms: "ClosedForms") -> Iterator[Equations | Paragraph]:
    """What the section of damping says."""
    damped = [mode for mode in forms.modes if mode.zeta is not None] if forms is not None else []
    if not damped:
        return
    if len(forms.modes) > 1:
        yield equations(_ratios(damped))
        yield paragraph("the modes are those without damping; ", maths("ω_d = ω·√(1 − ζ²)"), ", decay ",
                        maths("δ = ζ·ω"), hang=None)
        return
    mode, = damped
    if mode.zeta.op == "number" and mode.zeta.coefficient == 1:
        yield equations([line("ζ = 1", Words(":  critically damped"), hang=None),
                         line(Words("decay "), "δ = ω = ", mode.omega, hang=None)])
        return
    yield equations([
        line("ζ = ", mode.zeta, hang=None),
        line("ω_d = ω·√(1 − ζ²) = ", mode.omega_d, Words("  for "), "ζ < 1", hang=None),
        line(Words("decay "), "δ = ζ·ω = ", mode.zeta * mode.omega, hang=None), *_critical(forms)])
    yield paragraph("over-damped, ", maths("ζ > 1"), ":  decay rates ", maths("ω·(ζ ∓ √(ζ² − 1))"), hang=None)


def _critical(forms: "ClosedForms") -> "Iterator[Line]":
    if forms.critical is not None:
        letter, value = forms.critical
        yield line(Words("critical damping, "), "ζ = 1", Words(":  "), letter, " = ", value, hang=None)


def _ratios(damped: "Sequence[ClosedMode]") -> "Iterator[Line]":
    """ζ of each mode, as a function of ω where that is shorter."""
    done = set()
    for mode in damped:
        if mode.index not in done:
            same = [other for other in damped if mode.zeta_pattern and other.zeta_pattern is mode.zeta_pattern]
            head = ", ".join(f"ζ{lowered(other.index)}" for other in same or [mode])
            yield line(f"{head} = ", *((mode.zeta_pattern, *_with(same)) if same else (mode.zeta,)), hang=None)
            done |= {other.index for other in same}


def shape_blocks(problem: "Problem", names: Sequence[str], forms: "ClosedForms") -> list[Equations]:
    """What the section of mode shapes says."""
    lines, done = [], set()
    for mode in forms.modes:
        if mode.index in done or not (mode.pattern or mode.readable):
            continue
        same = [other for other in forms.modes if mode.pattern and other.pattern == mode.pattern] or [mode]
        done |= {other.index for other in same}
        shape = mode.pattern or mode.shape
        parts = []
        for i, (name, value) in enumerate(zip(names, shape, strict=True)):
            parts += [",  "] * bool(i) + [Name(name), " = ", *(turned(value) if mode.turns and i else (value,))]
        if any(part.name == OMEGA for part in reachable(shape)):
            parts += _with(same)
        label = Words(f"mode{'s' * (len(same) > 1)} {', '.join(str(other.index) for other in same)}")
        lines.append(line(*parts, label=label, hang=None))
    return [equations(lines) or paragraph(no_form(problem), hang=None)]


def turned(value: "Node") -> tuple[str | Factor, ...]:
    """Parts of i times an amplitude: a quarter period ahead."""
    negative = value.op != "sum" and value.coefficient < 0
    value = -value if negative else value
    sign = "−" * negative
    return (f"{sign}i",) if value.op == "number" and value.coefficient == 1 else (f"{sign}i·", Factor(value))


def _with(modes: "Sequence[ClosedMode]") -> tuple[Words, str]:
    return Words("   with "), "ω = " + ", ".join(f"ω{lowered(mode.index)}" for mode in modes)
