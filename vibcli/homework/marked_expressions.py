"""Answers that are expressions or equations, as students write them, against keys in letters or by their terms."""

import re
import unicodedata
from collections.abc import Mapping, Sequence
from typing import TYPE_CHECKING, Any

from vibcli.base.diagnostics import quoted
from vibcli.base.errors import PhysicsError, SpecError
from vibcli.base.spelling import nearest
from vibcli.check.instances import Instances
from vibcli.check.verdicts import expected_node, proportional, worst_place
from vibcli.homework import RIGHT, UNREADABLE, WRONG
from vibcli.homework.equation_reasons import of_terms
from vibcli.homework.formula_keys import agreements
from vibcli.homework.in_letters import LONGEST, answer_of, expression_of
from vibcli.homework.reasons import NOT_EQUAL, NOT_PROPORTIONAL
from vibcli.homework.terms import alike, fitted
from vibcli.language.dimension_check import TIMED
from vibcli.language.reader import Expression, Reader
from vibcli.quantities.quantity import EQUATION, OF_STATE, kind_of
from vibcli.reader.answer_check import as_quantity, checked
from vibcli.reader.sections.answer import Answer
from vibcli.results.random_states import at_states, states
from vibcli.symbolic.parser import plain_name
from vibcli.symbolic.syntax import ExpressionError

if TYPE_CHECKING:
    from vibcli.results.problem import Problem

SIGNS = str.maketrans({"−": "-", "–": "-", "×": "*", "⋅": "*", "·": "*", "’": "'", "′": "'", "″": "''", "√": "sqrt"})
RAISED = re.compile("[⁰¹²³⁴⁵⁶⁷⁸⁹⁻]+")
DIGITS = str.maketrans("⁰¹²³⁴⁵⁶⁷⁸⁹⁻₀₁₂₃₄₅₆₇₈₉", "0123456789-0123456789")
SLIPS = [("its sign", "-1"), *((f"a factor of {words}", factor) for words, factor in (
    ("2", "2"), ("1/2", "1/2"), ("4", "4"), ("1/4", "1/4"), ("2π", "2*pi"), ("1/(2π)", "1/(2*pi)")))]
DOTS = {"\u0307": "'", "\u0308": "''"}


def marked(problem: "Problem", key: Mapping[str, Any], text: str) -> tuple[str, str, str]:
    """(verdict, name of the mistake that an answer shows or '', what else to say) against a key of a manifest; problem:
    the scene of the variant."""
    asked = as_quantity(problem.spec, expression_of(key["quantity"]))
    try:
        given = answer_of(typed(text), problem.spec, asked) if len(text) <= LONGEST else None
    except ExpressionError as error:
        return UNREADABLE, "", error.message + (f": {error.hint}" if error.hint else "")
    if given is None:
        return UNREADABLE, "", f"this is longer than {LONGEST} characters"
    if (reason := _unknown(problem, asked, given)) is not None:
        return UNREADABLE, "", reason
    try:
        is_right, mistake = _compared(problem, asked, key, given)
        if is_right or mistake:
            return RIGHT if is_right else WRONG, mistake, ""
        return WRONG, "", _misfit(problem, asked, given) or _reason(problem, asked, key, given)
    except SpecError as error:
        return UNREADABLE, "", error.diagnostics[0].message
    except PhysicsError as error:
        return UNREADABLE, "", error.message


def typed(text: str) -> str:
    """An answer as the language has it: φ̈ + 2·δ·φ̇ as phi'' + 2*delta*phi', m₁² as m1^2."""
    found = unicodedata.normalize("NFD", text.strip().translate(SIGNS))
    found = "".join(DOTS.get(sign, sign) for sign in found)
    found = RAISED.sub(lambda power: f"^({power.group()})", found)
    return plain_name(found.translate(DIGITS))


def _unknown(problem: "Problem", asked: Expression, given: Expression) -> str | None:
    """What stands in an answer and is none of the letters that it may hold; None where nothing does."""
    spec, of_state = problem.spec, kind_of(problem.spec, asked.tree) in OF_STATE
    moving = (*spec.coordinates, "t") if of_state else ()
    names = {*spec.parameters, *moving, "pi"}
    for name, primes, *_ in given.parts.names:
        if name not in names:
            hint = nearest(name, names - {"pi"})
            return f"there is no letter {quoted(name)}" + (f"; {hint}" if hint else "")
        if (primes and name not in spec.coordinates) or primes > 2:
            return f"{quoted(name)} has no such derivative"
    for other in given.parts.quantities:
        return f"{quoted(other.text)} cannot stand in an answer: write it in letters"
    for call in given.parts.calls:
        if (call.name in TIMED and not of_state) or call.name in (spec.get("records") or ()):
            return f"'{call.name}' cannot stand in an answer"
    return None


def _compared(problem: "Problem", asked: Expression, key: Mapping[str, Any], given: Expression) -> tuple[bool, str]:
    """(is it right? the first mistake that leads to it, '' of none)."""
    if "terms" in key:
        found = [_has_terms(problem, asked, given, one["terms"], key["band"]) for one in (key, *key["mistakes"])]
    elif kind_of(problem.spec, asked.tree) in OF_STATE:
        right, = agreements(problem, [(asked, given)])
        found = [right, *_in_letters(problem, asked, given, [one["formula"] for one in key["mistakes"]])]
    else:
        texts = [one["formula"] for one in (key, *key["mistakes"])]
        found = agreements(problem, [(expression_of(text), given) for text in texts])
    named = (one["name"] for one, leads in zip(key["mistakes"], found[1:], strict=True) if leads)
    return found[0], next(named, "")


def _has_terms(problem: "Problem", asked: Expression, given: Expression, terms: Mapping[str, float],
               band: float) -> bool:
    """Has an equation these terms, up to a factor and each in its band?"""
    found = fitted(problem, asked, given, terms)
    return found is not None and alike(terms, found, band)


def _in_letters(problem: "Problem", asked: Expression, given: Expression, texts: Sequence[str]) -> list[bool]:
    """Does an energy or equation in letters equal each of some, at random values and states; equations up to a
    factor?"""
    others = [answer_of(text, problem.spec, asked) for text in texts]
    is_equation = kind_of(problem.spec, asked.tree) == EQUATION
    found, instances = [True] * len(texts), Instances(problem)
    for _, instance in zip(range(instances.wanted), instances, strict=False):
        at, groups = states(instance)
        values = at_states(instance, [expected_node(instance, one) for one in (given, *others)], at)
        for i, value in enumerate(values[1:]):
            factor, worst = proportional(values[0], value, groups) if is_equation else (
                1.0, worst_place(values[0], value, groups))
            found[i] = found[i] and factor != 0.0 and worst is None
    return found


def _misfit(problem: "Problem", asked: Expression, given: Expression) -> str:
    """Why an answer cannot be what is asked: its dimension, or a number without unit; '' of nothing."""
    if kind_of(problem.spec, asked.tree) in OF_STATE:
        return ""
    reader = Reader(members=problem.spec.members)
    checked(problem.spec, reader, Answer(asked, Expression(given.scalar, given.tree), None))
    return reader.diagnostics[0].message if reader.diagnostics else ""


def _reason(problem: "Problem", asked: Expression, key: Mapping[str, Any], given: Expression) -> str:
    """Why an answer is wrong to which no known mistake leads."""
    if "terms" in key:
        return of_terms(fitted(problem, asked, given, key["terms"]), key["terms"], key["band"])
    if kind_of(problem.spec, asked.tree) == EQUATION:
        return NOT_PROPORTIONAL
    texts = [f"({factor})*({key['formula']})" for _, factor in SLIPS]
    found = (_in_letters(problem, asked, given, texts) if kind_of(problem.spec, asked.tree) in OF_STATE else
             agreements(problem, [(expression_of(text), given) for text in texts]))
    but = next((words for (words, _), leads in zip(SLIPS, found, strict=True) if leads), None)
    return NOT_EQUAL if but is None else f"the expression is right but for {but}"
