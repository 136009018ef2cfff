"""The scenes that are measured, as texts."""

from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    from vibcli.symbolic.node import Node

BROKEN = """\
title: A bracket that is never closed
bodies:
  block: {mass: 2 kg, slide: [x
springs:
  s: {k: 3 kN/m, between: [ground, block]}
"""

ONE_DEGREE = """\
title: Mass on a spring
parameters: {m: 2 kg, k: 800 N/m}
bodies: {b: {mass: m, slide: x}}
springs: {s: {k: k, between: [ground, b]}}
"""

TWO_DEGREES = """\
title: Pendulum on a sprung cart
parameters: {M: 6 kg, m: 2 kg, L: 0.75 m, k: 240 N/m, g: 9.81 m/s^2}
gravity: g
bodies:
  cart: {mass: M, at: [0, 0], slide: x}
  bob: {mass: m, at: [0, -L], pin: {at: [0, 0], carrier: cart, by: phi}}
springs:
  s: {k: k, between: [[-0.5 m, 0], cart]}
answers:
  omega[1]: 3.36931 rad/s
"""

TWO_DRIVEN = """\
title: Two masses in a row, the first driven
parameters: {m: 2 kg, k: 800 N/m, c: 3 N*s/m}
bodies: {a: {mass: m, slide: x}, b: {mass: 2*m, slide: y}}
springs: {s: {k: k, between: [ground, a]}, t: {k: 2*k, between: [a, b]}}
dampers: {d: {c: c, between: [ground, a]}, e: {c: c, between: [a, b]}}
forces: {F: {at: a, force: 5 N*sin(10 rad/s*t)}}
"""

TWO_SYMBOLIC = """\
title: Double pendulum in letters
parameters: {m: , L: , g: }
gravity: g
bodies:
  upper: {mass: m, at: [0, -L], pin: {at: [0, 0], by: phi1}}
  lower: {mass: m, at: [0, -2*L], pin: {at: [0, -L], carrier: upper, by: phi2}}
"""


def pendulum(n: int) -> str:
    """n equal links, each hung on the one before; ω² = (g/L)·(the roots of the Laguerre polynomial of degree n)."""
    lines = ["parameters: {L: 1 m, m: 1 kg, g: 9.81 m/s^2}", "gravity: g", "bodies:"]
    for i in range(1, n + 1):
        pivot = f"b{i - 1}" if i > 1 else "[0, 0]"
        lines.append(f"  b{i}: {{mass: m, at: [0, -{i}*L], pin: {{at: {pivot}, by: a{i}}}}}")
    return "\n".join(lines) + "\n"


def chain(n: int, stiffnesses: Any = None, mass: "str | Node" = "1 kg") -> str:
    """n masses in a row, the first tied to the ground; equal springs unless `stiffnesses` (in N/m) says otherwise."""
    stiffnesses = stiffnesses or ["1000"] * n
    lines = ["bodies:"] + [f"  b{i}: {{mass: {mass}, slide: x{i}}}" for i in range(1, n + 1)] + ["springs:"]
    for i, k in enumerate(stiffnesses, 1):
        before = f"b{i - 1}" if i > 1 else "ground"
        lines.append(f"  s{i}: {{k: {k} N/m, between: [{before}, b{i}]}}")
    return "\n".join(lines) + "\n"
