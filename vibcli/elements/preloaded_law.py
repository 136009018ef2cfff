"""How far a nonlinear spring is deflected where its tension is N: F(d) = N, on the branch through d = 0.

    c |d|ⁿ sign d       d = (|N|/c)^(1/n) sign N
    k d + q d |d|       d = 2 n/(1 + √(1 + 4 (q/k) |n|)),   n = N/k
    k d + g d³          d = 3 n/(w² + 1 + 1/w²),  w³ = u + √(1 + u²),  u = ½ √(27 g/k) |n|      (Cardano's, for g/k > 0)
                        d = 2 sin(⅓ asin(³⁄₂ n √(3 h)))/√(3 h),  h = −g/k                       (for g/k < 0)
"""

from fractions import Fraction
from typing import TYPE_CHECKING, Any

from vibcli.symbolic.power_law import cubic_root, odd_powers

if TYPE_CHECKING:
    from vibcli.language.reader import Record
    from vibcli.symbolic.node import Node


def undeformed(record: "Record", scene: Any, law: "Node", d: "Node", tension: "Node") -> "Node | None":
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
    scene.report(record.place("preload"), f"where the law of '{record.name}' has the tension `preload` is not found",
                 "it is of k*d, of k*d + q*d*abs(d) or k*d + g*d^3, and of one power; else write the law with d "
                 "shifted, as in F(d + d0)")
    return None


def _call(name, u):
    return u.table.call(name, u)


def _is_reached(record, scene, load, bend, degree):
    """Has a law that weakens this tension on its branch through d = 0? If not, it is reported."""
    b = -scene.number(bend)
    if record["preload"] == "static":
        if b > 0:
            scene.report(record.place("preload"), f"the law of '{record.name}' weakens as it is deflected: it may have "
                         "no such tension", "give its tension as drawn")
        return b <= 0
    n = abs(scene.number(load))
    most = 0 if b <= 0 else 1 / (4 * b) if degree == 2 else 2 / (27 * b) ** 0.5
    if b <= 0 or n <= most:
        return True
    share = f"{most / n:.4g}"
    scene.report(record.place("preload"), f"the law of '{record.name}' has no such tension: it rises to {share} of it",
                 "give a smaller preload")
    return False


def _quadratic(load, bend):
    return 2 * load / (1 + (1 + 4 * bend * _call("abs", load)) ** Fraction(1, 2))


def _cubic(scene, load, bend):
    table = load.table
    if scene.number(bend) > 0:
        return cubic_root(load, bend)
    root = table.sqrt(-3 * bend)
    return 2 * _call("sin", _call("asin", load * root * Fraction(3, 2)) / 3) / root
