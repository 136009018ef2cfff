"""The same numbers by the other ways that they are told: reports read back, letters with values set, digits, cases."""

import re

import mpmath

from . import doors, mechanics
from .as_yaml import scene_of, text_of
from .figure import Figure
from .in_letters import closed_forms
from .texts import precise

NUMBER = re.compile(r"(?<![\w.^{])-?\d+\.?\d*(?:[eE][-+]?\d+)?(?:\s*(?:\\cdot|·)\s*10\s*\^?\{?([-⁻⁰¹²³⁴⁵⁶⁷⁸⁹\d]+)\}?)?")
SMALL_DIGITS = str.maketrans("⁻⁰¹²³⁴⁵⁶⁷⁸⁹", "-0123456789")
PRINTED = 6e-6                  # half a unit of the sixth digit, of numbers that begin with 1


def numbers(line):
    """The numbers of a line, powers of ten included."""
    found = []
    for match in NUMBER.finditer(line.replace("−", "-")):
        head = re.match(r"-?\d+\.?\d*(?:[eE][-+]?\d+)?", match[0])[0]
        found.append(float(head) * 10.0 ** int((match[1] or "0").translate(SMALL_DIGITS)))
    return found


def rows(report, heading):
    """The lines of the table below a heading."""
    lines = report.splitlines()
    begin = next((i for i, line in enumerate(lines) if heading in line), None)
    found = []
    for line in lines[begin + 1:] if begin is not None else ():
        bare = line.strip()
        if found and not re.match(r"^[|{]|^\S.*\d", bare):
            break
        if bare and not re.match(r"^(mode|signal|\|\s*(mode|signal|---)|\\)", bare):
            found.append(bare)
    return found


def report(style):
    """Natural frequencies, and values in time, as a report of a style tells them."""
    def compare(comparison):
        told = doors.printed("frequencies", comparison.path, "--format", style)
        modes = [mode for mode in comparison.data["modes"] if mode["omega"] and mode["growth_rate"] is None]
        lines = {int(numbers(row)[0]): numbers(row) for row in rows(told, "Natural frequencies") if numbers(row)}
        for mode in modes:
            found = lines.get(mode["index"], [0.0, 0.0])[1]
            comparison.meet(f"{style}: omega[{mode['index']}]", mode["omega"], found, PRINTED * mode["omega"])
        values_told(comparison, style)
    return compare


def values_told(comparison, style):
    """Values at an instant, in twelve digits."""
    small = comparison.instants.get(False)
    if not small:
        return
    t = next(iter(small)).partition("(")[2].partition(" ")[0]
    told = doors.printed("response", comparison.path, "--at", t, "--format", style)
    lines = rows(told, "Values")
    names = [name for name in comparison.figure.coordinates if f"{name}({t} s)" in small]
    largest = max(map(abs, small.values()))
    every = list(comparison.figure.coordinates)
    for name, line in zip(every, lines, strict=False):
        if name in names and len(lines) == len(every):
            comparison.meet(f"{style}: {name}({t} s)", small[f"{name}({t} s)"], numbers(line)[-1], 1e-8 * largest)


def letters(comparison):
    """Every parameter without value in the file, given by --set."""
    scene = scene_of(comparison.text)
    given = scene.get("parameters", {})
    scene["parameters"] = {name: {"unit": text.partition(" ")[2], "sign": "any"} for name, text in given.items()}
    path = comparison.path.with_name("letters.yaml")
    path.write_text(text_of(scene), encoding="utf-8")
    options = [word for name, text in given.items() for word in ("--set", f"{name}={text}")]
    data = doors.data("frequencies", path, *options)
    same(comparison, data, "--set: ")


def same(comparison, data, door):
    """Equilibrium, matrices where they are told, and eigenvalues of another answer."""
    for name, value in zip(comparison.figure.independent, comparison.q, strict=True):
        comparison.meet(f"{door}equilibrium[{name}]", value, data["equilibrium"]["coordinates"][name], 1e-9)
    if "matrices" in data:
        comparison.matrices(data, door)
    comparison.eigenvalues(data, door)


def cases(comparison):
    """The scene as a case of one with another value of a parameter."""
    scene = scene_of(comparison.text)
    soft = [name for name in scene.get("parameters", {}) if re.match(r"[kqmJ]\d", name)]
    if not soft:
        return
    name = soft[0]
    size, _, unit = scene["parameters"][name].partition(" ")
    scene["cases"] = {"as drawn": {"parameters": {name: scene["parameters"][name]}}}
    scene["parameters"][name] = f"{1.07 * float(size):.6g} {unit}"
    path = comparison.path.with_name("cases.yaml")
    path.write_text(text_of(scene), encoding="utf-8")
    same(comparison, doors.data("frequencies", path)["cases"]["as drawn"], "case: ")


def digits(comparison):
    """Natural frequencies to twenty digits, against the same mechanics in numbers of fifty."""
    small = comparison.small
    gyroscopic = max(abs(small.C - small.drag).max(), abs(small.C - small.C.T).max()) > 1e-9
    if comparison.figure.statics or gyroscopic or len(comparison.q) > 3:
        return          # no preloads found in floats
    told = doors.data("frequencies", comparison.path, "--digits", 20)
    with mpmath.workdps(50):
        figure = Figure(comparison.text, literal=precise, folder=comparison.path.parent)
        figure.independent = comparison.figure.independent
        q = mechanics.equilibrium(figure, [mpmath.mpf(float(x)) for x in comparison.q], 1e-40)
        small = mechanics.small(figure, q)
        squares = mpmath.eig(mpmath.matrix(small.M.tolist()) ** -1 * mpmath.matrix(small.K.tolist()))[0]
        for mode in told["modes"]:
            if mode["growth_rate"] is None and mpmath.mpf(mode["omega"]) > 0:
                omega = mpmath.mpf(mode["omega"])
                near = min((mpmath.sqrt(square) for square in squares), key=lambda x: abs(x - omega))
                comparison.meet(f"digits: omega[{mode['index']}]", near, omega, 1e-19 * omega)


ALL = {"text": report("text"), "markdown": report("markdown"), "latex": report("latex"), "--set": letters,
       "--digits": digits, "cases": cases, "closed forms": closed_forms}
