"""How far a nonlinear spring is deflected where its tension is N: F(d) = N, on the branch through d = 0.

    c |d|ⁿ sign d       d = (|N|/c)^(1/n) sign N
    k d + q d |d|       d = 2 n/(1 + √(1 + 4 (q/k) |n|)),   n = N/k
    k d + g d³          d = 3 n/(w² + 1 + 1/w²),  w³ = u + √(1 + u²),  u = ½ √(27 g/k) |n|      (Cardano's, for g/k > 0)
                        d = 2 sin(⅓ asin(³⁄₂ n √(3 h)))/√(3 h),  h = −g/k                       (for g/k < 0)
    others              by a root, a function of N and of the parameters (symbolic/roots_of_laws.py)
"""

from fractions import Fraction
from math import inf, isfinite
from typing import TYPE_CHECKING

from vibcli.symbolic.power_law import cubic_root, odd_powers

if TYPE_CHECKING:
    from vibcli.language.reader import Record
    from vibcli.scene.builder import Builder
    from vibcli.symbolic.node import Node


def undeformed(record: "Record", scene: "Builder", law: "Node", d: "Node", tension: "Node") -> "Node | None":
    """The deflection d₀ with F(d₀) = N; None where it is not found, which is reported."""
    if tension.is_zero:
        return tension
    powers = odd_powers(law, d)
    degrees = sorted(powers or ())
    if len(degrees) == 1:
        ratio, n = tension / powers[degrees[0]], degrees[0]
        return _call("sign", ratio) * _call("abs", ratio) ** (1 / Fraction(n))
    if degrees in ([1, 2], [1, 3]):
        load, bend = tension / powers[1], powers[degrees[1]] / powers[1]
        if not _is_reached(record, scene, load, bend, degrees[1]):
            return None
        return _quadratic(load, bend) if degrees[1] == 2 else _cubic(scene, load, bend)
    return _root(record, scene, law, d, tension)


def _root(record: "Record", scene: "Builder", law: "Node", d: "Node", tension: "Node") -> "Node | None":
    """The deflection as a function of the tension and of the parameters, found by a root where it is asked for."""
    from vibcli.symbolic.roots_of_laws import RootOfLaw

    function = RootOfLaw(record.name + ".undeformed", law, d)
    p = [scene.number(symbol) for symbol in function.symbols]
    if record["preload"] == "static":
        ends = [function.followed(N, p) for N in (-inf, inf)]
        if any(isfinite(end.where) and not end.ends for end in ends):
            _weakens(record, scene)
            return None
        return function.called(tension)
    N = scene.number(tension)
    branch = function.followed(N, p)
    if branch.jumps:
        scene.report(record.place("preload"), f"the law of '{record.name}' jumps past this tension",
                     "give a tension that it has at some deflection")
    elif not isfinite(branch.d):
        _too_much(record, scene, branch.most / N, branch.where, "ends at" if branch.ends else "rises to")
    return function.called(tension) if isfinite(branch.d) and not branch.jumps else None


def _call(name: str, u: "Node") -> "Node":
    return u.table.call(name, u)


def _is_reached(record: "Record", scene: "Builder", load: "Node", bend: "Node", degree: Fraction | int) -> bool:
    """Has a law that weakens this tension on its branch through d = 0? If not, it is reported."""
    b = -scene.number(bend)
    if record["preload"] == "static":
        if b > 0:
            _weakens(record, scene)
        return b <= 0
    N = scene.number(load)
    n = abs(N)
    most = 0 if b <= 0 else 1 / (4 * b) if degree == 2 else 2 / (27 * b) ** 0.5
    if b <= 0 or n <= most:
        return True
    _too_much(record, scene, most / n, (1 / (2 * b) if degree == 2 else (3 * b) ** -0.5) * (1 if N > 0 else -1))
    return False


def _weakens(record: "Record", scene: "Builder") -> None:
    scene.report(record.place("preload"), f"the law of '{record.name}' weakens as it is deflected: it may have no such "
                 "tension", "give its tension as drawn")


def _too_much(record: "Record", scene: "Builder", share: float, where: float, does: str = "rises to") -> None:
    """`share`: of the tension, that the law rises to at the deflection `where`, inf in the limit."""
    unit = "" if "stretch" in record else " rad" if "torsion" in record else " m"
    place = f", at d = {where:.4g}{unit}" if isfinite(where) else ""
    scene.report(record.place("preload"), f"the law of '{record.name}' has no such tension: it {does} {share:.4g} of "
                 f"it{place}", "give a smaller preload")


def _quadratic(load: "Node", bend: "Node") -> "Node":
    return 2 * load / (1 + (1 + 4 * bend * _call("abs", load)) ** Fraction(1, 2))


def _cubic(scene: "Builder", load: "Node", bend: "Node") -> "Node":
    table = load.table
    if scene.number(bend) > 0:
        return cubic_root(load, bend)
    root = table.sqrt(-3 * bend)
    return 2 * _call("sin", _call("asin", load * root * Fraction(3, 2)) / 3) / root
