"""Closed forms: a scene whose parameters are letters, its answers evaluated at other values than those of the file."""

import contextlib
import random
import re
import unicodedata

import numpy as np
from support import formulas, typeset

from . import doors, mechanics, words
from .as_yaml import scene_of, text_of

MOST = 2                # coordinates
GREEK = "phi", "alpha", "beta", "sigma", "lambda"


def closed_forms(comparison):
    """Equilibrium, matrices, frequencies, damping in letters, at values a few percent from those of the scene."""
    from .compare import figure_of

    if len(comparison.q) > MOST or comparison.figure.statics or len(comparison.figure.coordinates) > MOST:
        return
    scene = scene_of(comparison.text)
    dice, given = random.Random(comparison.text), {}
    for name, text in scene.get("parameters", {}).items():
        size, _, unit = text.partition(" ")
        given[name] = f"{float(size) * dice.uniform(0.97, 1.03):.6g} {unit}"
    scene["parameters"] = {name: {"unit": text.partition(" ")[2], "sign": "positive"} for name, text in given.items()}
    path = comparison.path.with_name("letters.yaml")
    path.write_text(text_of(scene), encoding="utf-8")
    told = doors.data("solve", path)
    figure = figure_of(comparison.text, told["coordinates"], folder=comparison.path.parent, given=given)

    def value(text):
        return words.value(words.read(text), figure.parameters, figure.literal, figure.functions)

    _forms(comparison, figure, told, value)
    for equation in told["equations"] or ():
        with contextlib.suppress(ValueError):           # a root of what is negative there
            typeset_as_written(comparison, equation, dice)


def _forms(comparison, figure, told, value):
    forms = (told["equilibrium"] or {}).get("coordinates") or {}
    names = figure.independent
    if not all(forms.get(name) for name in names):
        return
    theirs = [value(forms[name]) for name in names]
    q = mechanics.equilibrium(figure, theirs)
    if q is None:
        return
    for name, ours, found in zip(names, q, theirs, strict=True):
        comparison.meet(f"letters: equilibrium[{name}]", ours, found, 1e-9)
    small = mechanics.small(figure, q)
    _matrices(comparison, small, told["matrices"] or {}, value)
    from .compare import spectrum

    natural = spectrum(small, (small.C - small.C.T) / 2)
    damped = spectrum(small, small.C)
    for mode in told["modes"] or ():
        if mode.get("omega"):
            _near(comparison, f"letters: omega[{mode['index']}]", value(mode["omega"]), natural.imag)
    for mode in told["damped"] or ():
        if mode.get("omega") and mode.get("zeta") and mode.get("omega_d") and value(mode["zeta"]) < 1:
            omega, zeta = value(mode["omega"]), value(mode["zeta"])
            _near(comparison, f"letters: omega_d[{mode['index']}]", value(mode["omega_d"]), damped.imag)
            _near(comparison, f"letters: zeta[{mode['index']}]", -zeta * omega, damped.real)


def _near(comparison, what, found, values):
    near = min(values, key=lambda other: abs(other - found))
    comparison.meet(what, near, found, 1e-8 * max(abs(values)))


def _matrices(comparison, small, given, value):
    for key, ours in (("M", small.M), ("K", small.K)):
        for i, row in enumerate(given.get(key) or ()):
            for j, text in enumerate(row):
                comparison.meet(f"letters: {key}[{i + 1},{j + 1}]", ours[i, j], value(text), 1e-9 * np.abs(ours).max())


def typeset_as_written(comparison, equation, dice):
    """The LaTeX of an equation has the value of its text, whatever its letters are."""
    if not equation["latex"] or re.search("ag|impulse|square|sawtooth|step|ramp|sign|abs|max|min", equation["text"]):
        return
    figure = comparison.figure
    trees = [words.read(side) for side in equation["text"].split("=")]
    names = {name for tree in trees for name in words.names(tree)} - {"pi"}
    at = {name: dice.uniform(0.2, 0.8) for name in names}
    values = {_symbol(name): x for name, x in at.items()}
    for tree, latex in zip(trees, equation["latex"].split("="), strict=True):
        ours = words.value(tree, at, figure.literal, figure.functions)
        found = formulas.value(typeset.latex(latex), lambda symbol: values.get(symbol, np.pi))
        comparison.meet("letters: LaTeX", ours, found, 1e-6 * max(1.0, abs(ours)))


def _symbol(name):
    """A name as formulas.py has it."""
    word, primes = name.partition("__")[::2]
    letters, index = re.match(r"([A-Za-z]+)(\w*)", word).groups()
    if letters in GREEK:
        letters = unicodedata.lookup(f"GREEK SMALL LETTER {letters.upper().replace('LAMBDA', 'LAMDA')}")
    return formulas.symbol(letters + index) + "'" * int(primes or 0)
