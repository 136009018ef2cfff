"""The formulas of reports in every notation, each read back and compared with the expressions that it was made of."""

import math
import re
import zlib
from itertools import groupby

from support.formulas import (
    FUNCTIONS,
    Unreadable,
    agree,
    bracketed,
    flattened,
    plain,
    raised,
    sides,
    symbol,
    value,
)
from support.typeset import latex, mathml, typst

from vibcli.notation.latex import latex as write_latex
from vibcli.notation.mathml import mathml as write_mathml
from vibcli.notation.plain import plain as write_plain
from vibcli.notation.typst import typst as write_typst
from vibcli.report.blocks import Either, Line, Maths, Name, Picture, SumOfTerms, Typed, Words
from vibcli.report.formats.formula import formula
from vibcli.report.formats.markdown import latex as write_protected
from vibcli.symbolic.evaluation import Floats, evaluate
from vibcli.symbolic.expression_graph import reachable

NOTATIONS = {"text": (write_plain, plain), "LaTeX": (write_latex, latex), "Markdown": (write_protected, latex),
             "MathML": (write_mathml, mathml), "Typst": (write_typst, typst)}


def of_documents(documents):
    """The parts of every formula of the documents, cut where words stand within one."""
    pending, found = list(documents), []
    while pending:
        one = pending.pop()
        if isinstance(one, (Maths, Line)):
            found += [list(group) for words, group in groupby(one.parts, lambda part: isinstance(part, Words))
                      if not words]
        elif isinstance(one, tuple) and not isinstance(one, (Picture, Name)):
            pending.extend(one)
    return found


class Values(dict):
    """{symbol of a scene: its value}; any other symbol has a value of its own, s.force and Δx the product of what they
    are written of."""

    def __missing__(self, name):
        if "." in name:
            return math.prod(map(self.__getitem__, name.split(".")))
        if name[0] == "Δ" and name[1:]:
            return self["Δ"] * self[name[1:]]
        key = symbol(write_plain.symbol(name))
        return math.pi if key == "π" else 0.5 + zlib.crc32(key.encode()) % 1000 / 1000


def compared(parts, numbers):
    """How many sides of a formula are the same number in all notations, and as its expressions say; AssertionError
    where one differs, 0 where plain text is no formula. `numbers`: {symbol of the scene: its value}."""
    numbers = Values(numbers)
    keyed = Values({symbol(write_plain.symbol(name)): number for name, number in numbers.items()})
    texts = {name: formula(parts, write) for name, (write, _) in NOTATIONS.items()}
    try:
        wanted = [value(side, keyed.__getitem__) for side in sides(plain(texts["text"]))]
    except (Unreadable, OverflowError, ZeroDivisionError):
        return 0
    readings = {name: read(texts[name]) for name, (_, read) in NOTATIONS.items()}
    if (meant := as_meant(parts, numbers)) is not None:
        readings["as meant"] = meant
    for name, tokens in readings.items():
        found = [value(side, keyed.__getitem__) for side in sides(tokens)]
        assert len(found) == len(wanted) and all(map(agree, found, wanted)), (
            f"{texts['text']}\n{name}: {texts.get(name)}")
    return len(wanted)


def as_meant(parts, numbers):
    """The tokens of a formula in which every expression is one number; None where one has no value."""
    flat = []
    for part in parts:
        if isinstance(part, str):
            flat += flattened(part)
        elif isinstance(part, Name):
            flat.append(("symbol", symbol(write_plain.symbol(part.text))))
        elif isinstance(part, Typed):       # it has no expression of the scene
            return None
        else:
            nodes = part.nodes if isinstance(part, SumOfTerms) else [getattr(part, "node", part)]
            if any(one.op == "call" and one.name not in FUNCTIONS for one in reachable(nodes)):
                return None
            found = _lower(part, numbers) if isinstance(part, Either) else sum(evaluate(nodes, Floats, numbers))
            if found != found:
                return None
            flat.append(("number", repr(found)))
    return raised(bracketed(flat))


def _lower(either, numbers):
    """a − b of a + b, b the multiple of the root: its mark is the root of a symbol."""
    root, = evaluate([either.root], Floats, numbers)
    (mark, _), = either.mark.args
    found = [evaluate([either.node], Floats, Values({**numbers, mark.name: size}))[0] for size in (0.0, root * root)]
    return 2 * found[0] - found[1]


def compared_texts(text, tex, numbers):
    """An equation in the language of scenes, and as LaTeX: the same on both sides."""
    if text is None:
        return
    keyed = Values({symbol(write_plain.symbol(name)): number for name, number in numbers.items()})
    text = re.sub(r"[A-Za-z]\w*'*", lambda name: name[0] if name[0] in FUNCTIONS else write_plain.symbol(name[0]), text)
    wanted = [value(side, keyed.__getitem__) for side in sides(plain(text))]
    found = [value(side, keyed.__getitem__) for side in sides(latex(tex))]
    assert len(found) == len(wanted) and all(map(agree, found, wanted)), f"{text}\n{tex}"
