"""What a uniform piece of a member is at rest: springs, exactly.

Order 2, N u″ = k u, with β = √(k/N): Nβ/sinh βl between its ends and Nβ tanh(βl/2) from each to the ground; N/l without
a foundation. Order 4, EI u⁗ − N u″ = 0, with λ² = N l²/(4EI), negative where it is compressed:

    N/l on u_l − u₀,   EI/l · g on θ_l − θ₀,   EI/l · 4λ²/(g − 1) on (θ₀ + θ_l)/2 − (u_l − u₀)/l,   g = λ coth λ

and without tension 12EI/l³ on u_l − u₀ − l(θ₀ + θ_l)/2 (Przemieniecki 1968, ch. 5 and 15). On a foundation the even
and the odd deflections about the middle are two springs each.
"""

from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from collections.abc import Sequence

    from vibcli.scene.builder import Builder
    from vibcli.scene.scene import Scene
    from vibcli.symbolic.expression import Table
    from vibcli.symbolic.node import Node

SMALL, TINY, DEPTH = 0.25, 1e-6, 24     # below TINY the functions themselves are right to fewer digits than are shown


def springs_along(scene: "Builder | Scene", length: "Node", tension: "Node", foundation: "Node",
                  ends: "Sequence[Node]", gradient: "Node") -> "list[tuple[Node, Node]]":
    """[(stiffness, stretch)] of a piece of order 2; none where the tension N + n x vanishes at an end."""
    first, last = ends
    if not gradient.is_zero:
        share = _share(length, tension, gradient)
        if not scene.number(share * share) < 1 - 2.0**-39:
            return []
        return [((tension + gradient * length / 2) / length * _graded(scene, share)[0], last - first)]
    if foundation.is_zero:
        return [(tension / length, last - first)]
    beta = scene.table.sqrt(foundation / tension)
    between = tension * beta / scene.table.call("sinh", beta * length)
    to_ground = tension * beta * scene.table.call("tanh", beta * length / 2)
    return [(between, last - first), (to_ground, first), (to_ground, last)]


def springs_across(scene: "Builder | Scene", length: "Node", bending: "Node", tension: "Node", foundation: "Node",
                   ends: "Sequence[Node]") -> "list[tuple[Node, Node]]":
    """[(stiffness, stretch)] of a piece of a beam."""
    first, turned, last, turned_last = ends
    if not foundation.is_zero:
        return _on_foundation(scene, length, bending, tension, foundation, ends)
    if tension.is_zero:
        return [(12 * bending / length**3, last - first - length * (turned + turned_last) / 2),
                (bending / length, turned_last - turned)]
    z = tension * length * length / (4 * bending)
    even, odd = _stability_functions(scene, z)
    return [(tension / length, last - first), (bending / length * even, turned_last - turned),
            (bending / length * odd, (turned + turned_last) / 2 - (last - first) / length)]


def mean_along(scene: "Builder | Scene", length: "Node", tension: "Node", foundation: "Node", ends: "Sequence[Node]",
               gradient: "Node | None" = None) -> "Node":
    """Mean displacement of a piece of order 2 without loads of its own, by which loads spread evenly act."""
    first, last = ends
    mean = (first + last) / 2
    if gradient is not None and not gradient.is_zero:
        share = _share(length, tension, gradient)
        value = scene.number(share)
        if not value * value < 1 - 2.0**-39:
            return last if value > 0 else first
        return mean + (last - first) * _graded(scene, share)[1] / 2
    if foundation.is_zero:
        return mean
    half = scene.table.sqrt(foundation / tension) * length / 2
    return mean * scene.table.call("tanh", half) / half


def share_along(scene: "Builder | Scene", x: "Node", tension: "Node", gradient: "Node") -> "Node | None":
    """½ log(1 + n x/N) = artanh r; None where there is no tension at 0 or at x."""
    r = _share(x, tension, gradient)
    return r / _graded(scene, r)[0] if scene.number(r * r) < 1 - 2.0**-39 else None


def _share(length: "Node", tension: "Node", gradient: "Node") -> "Node":
    """r = n l/(2N + n l), how far the tension varies about its mean."""
    return gradient * length / (2 * tension + gradient * length)


def _graded(scene: "Builder | Scene", r: "Node") -> "tuple[Node, Node]":
    """(r/artanh r, (1 − r/artanh r)/r) of u′ ~ 1/(N + n x), near r = 0 by the continued fraction
    r/artanh r = 1 − r²/(3 − 4r²/(5 − …))."""
    table = scene.table
    if abs(scene.number(r)) < SMALL and not scene.parameters.untold:
        above, below = _fraction(table, r * r, [-((k + 1) ** 2) for k in range(1, DEPTH)])
        return 1 - r * r * below / above, r * below / above
    found = 2 * r / table.call("log", (1 + r) / (1 - r))
    return found, (1 - found) / r


def mean_across(scene: "Builder | Scene", length: "Node", bending: "Node", tension: "Node", foundation: "Node",
                ends: "Sequence[Node]") -> "Node":
    """The same of a piece of a beam; on a foundation its force, k times this, is that on the ends."""
    first, turned, last, turned_last = ends
    mean = (first + last) / 2
    if not foundation.is_zero:
        a, b, _ = _end_stiffness(even_solutions(scene, length / 2, bending, tension, foundation), bending, tension)
        return (a * mean + b * (turned_last - turned) / 2) * 2 / (foundation * length)
    odd = scene.table.number(12) if tension.is_zero else _stability_functions(
        scene, tension * length * length / (4 * bending))[1]
    return mean - length / odd * (turned_last - turned)


def _stability_functions(scene: "Builder | Scene", z: "Node") -> "tuple[Node, Node]":
    """g(z) = λ coth λ and 4z/(g − 1), z = λ²; of numbers near z = 0, where their difference loses digits, by Lambert's
    continued fraction g = 1 + z/(3 + z/(5 + …)), which is then right to more digits than anybody asks for."""
    table, value = scene.table, scene.number(z)
    root = table.sqrt(z if value > 0 else -z)
    even = root / table.call("tanh" if value > 0 else "tan", root)
    if abs(value) < SMALL and not scene.parameters.untold:
        above, below = _fraction(table, z, [1] * (DEPTH - 1))
        if abs(value) > TINY:
            scene.contents.fractions.update({above: z / (even - 1), 4 * above: 4 * z / (even - 1), below: table.one})
        return 1 + z * below / above, 4 * above / below
    return even, 4 * z / (even - 1)


def _fraction(table: "Table", z: "Node", factors: list[int]) -> "tuple[Node, ...]":
    """(P, Q), polynomials in z, with P/Q = 3 + f₁ z/(5 + f₂ z/(7 + …)): one division, which forms in letters bear."""
    above, below = [2 * DEPTH + 1], [1]
    for k in range(DEPTH - 1, 0, -1):
        shifted = [0, *(factors[k - 1] * c for c in below)]
        longer = [(2 * k + 1) * c for c in above] + [0] * (len(shifted) - len(above))
        above, below = [c + (shifted[i] if i < len(shifted) else 0) for i, c in enumerate(longer)], above
    return tuple(table.sum(*((z**i, c) for i, c in enumerate(found))) for found in (above, below))


def _on_foundation(scene: "Builder | Scene", length: "Node", bending: "Node", tension: "Node", foundation: "Node",
                   ends: "Sequence[Node]") -> "list[tuple[Node, Node]]":
    """Even and odd deflections about the middle: the forces at the right end by its displacement and slope, symmetric
    [[a, b], [b, c]], are the springs a on v + (b/a) θ and c − b²/a on θ, for each half of the piece."""
    first, turned, last, turned_last = ends
    found = []
    for basis, v, slope in ((even_solutions, (last + first) / 2, (turned_last - turned) / 2),
                            (odd_solutions, (last - first) / 2, (turned_last + turned) / 2)):
        a, b, c = _end_stiffness(basis(scene, length / 2, bending, tension, foundation), bending, tension)
        found += [(2 * a, v + b / a * slope), (2 * (c - b * b / a), slope)]
    return found


def _end_stiffness(pair: "Sequence[tuple[Node, ...]]", bending: "Node", tension: "Node") -> "tuple[Node, Node, Node]":
    """(a, b, c) of two solutions, each as (u, u′, u″, u‴) at the right end: Q = N u′ − B u‴, M = B u″."""
    (u, u1, u2, u3), (w, w1, w2, w3) = pair
    determinant = u * w1 - w * u1
    forces = [tension * d1 - bending * d3 for d1, d3 in ((u1, u3), (w1, w3))]
    return ((forces[0] * w1 - forces[1] * u1) / determinant, (forces[1] * u - forces[0] * w) / determinant,
            bending * (w2 * u - u2 * w) / determinant)


def even_solutions(scene: "Builder | Scene", x: "Node", bending: "Node", tension: "Node",
                   foundation: "Node") -> "list[tuple[Node, ...]]":
    """Two even solutions of B u⁗ − N u″ + k u = 0, k or N not zero, as (u, u′, u″, u‴) at x."""
    if foundation.is_zero:
        return [_one(scene, x, tension / bending, ("cosh", "sinh"), ("cos", "sin")), _powers(scene, scene.table.one)]
    return _solutions(scene, x, bending, tension, foundation, ("cosh", "sinh"), ("cos", "sin"))


def odd_solutions(scene: "Builder | Scene", x: "Node", bending: "Node", tension: "Node",
                  foundation: "Node") -> "list[tuple[Node, ...]]":
    """Two odd ones."""
    if foundation.is_zero:
        return [_one(scene, x, tension / bending, ("sinh", "cosh"), ("sin", "cos")),
                _powers(scene, x, scene.table.one)]
    return _solutions(scene, x, bending, tension, foundation, ("sinh", "cosh"), ("sin", "cos"))


def _powers(scene: "Builder | Scene", *known: "Node") -> "tuple[Node, ...]":
    return (*known, *[scene.table.zero] * (4 - len(known)))


def _solutions(scene: "Builder | Scene", x: "Node", bending: "Node", tension: "Node", foundation: "Node",
               hyperbolic: "tuple[str, str]", circular: "tuple[str, str]") -> "list[tuple[Node, ...]]":
    """Two solutions of B u⁗ − N u″ + k u = 0 of one parity, as (u, u′, u″, u‴) at x."""
    table = scene.table
    discriminant = tension * tension - 4 * bending * foundation
    if scene.number(discriminant) >= 0:     # two real squares, r² = (N ± √(N² − 4Bk))/(2B)
        root = table.sqrt(discriminant)
        squares = [(tension + sign * root) / (2 * bending) for sign in (1, -1)]
        return [_one(scene, x, square, hyperbolic, circular) for square in squares]
    real = table.sqrt(table.sqrt(foundation / bending) / 2 + tension / (4 * bending))
    imaginary = table.sqrt(table.sqrt(foundation / bending) / 2 - tension / (4 * bending))
    return _two(table, x, real, imaginary, hyperbolic, circular)


def _one(scene: "Builder | Scene", x: "Node", square: "Node", hyperbolic: "tuple[str, str]",
         circular: "tuple[str, str]") -> "tuple[Node, ...]":
    """cosh rx or sinh rx, of negative r² cos or sin, with its derivatives."""
    table, positive = scene.table, scene.number(square) > 0
    r = table.sqrt(square if positive else -square)
    same, other = (table.call(name, r * x) for name in (hyperbolic if positive else circular))
    slope = r * other if positive or circular[0] == "sin" else -(r * other)
    return same, slope, square * same, square * slope


def _two(table: "Table", x: "Node", a: "Node", b: "Node", hyperbolic: "tuple[str, str]",
         circular: "tuple[str, str]") -> "list[tuple[Node, ...]]":
    """cosh ax cos bx and sinh ax sin bx, or sinh ax cos bx and cosh ax sin bx, with their derivatives: of f = h c they
    are the real and the imaginary part of powers of a + ib times those of cosh (a + ib)x, or sinh."""
    same, other = (table.call(name, a * x) for name in hyperbolic)
    cos, sin = (table.call(name, b * x) for name in ("cos", "sin"))
    value, conjugate = (same * cos, other * sin), (other * cos, same * sin)   # of the function, of its companion
    found, power = [value], (a, b)
    for order in (1, 2, 3):
        re, im = conjugate if order % 2 else value
        found.append((power[0] * re - power[1] * im, power[0] * im + power[1] * re))
        power = (power[0] * a - power[1] * b, power[0] * b + power[1] * a)
    return [tuple(pair[i] for pair in found) for i in (0, 1)]
