"""Members by transfer matrices in many digits, to derive answers with: states go from left to right, point by point.

Of bars, shafts and strings the state is (u, S u'), of beams (u, u', EI u'', -EI u'''): displacement, slope, moment and
shear force on the part to the right. Digits are many, so that nothing is lost by exponentials (Pestel & Leckie 1963).
"""

from mpmath import cos, cos_sin, det, exp, findroot, matrix, mpf, sin, sqrt


def bar(length, stiffness, inertia):
    """w -> transfer matrix of a uniform bar, shaft or string."""
    def at(w):
        b = w * sqrt(inertia / stiffness)
        if not b:
            return matrix([[1, length / stiffness], [0, 1]])
        return matrix([[cos(b * length), sin(b * length) / (stiffness * b)],
                       [-stiffness * b * sin(b * length), cos(b * length)]])
    return at


def beam(length, EI, mu):
    """w -> transfer matrix of a uniform beam."""
    def at(w):
        b = sqrt(w * sqrt(mu / EI))
        z = b * length
        (c, s), grown = cos_sin(z), exp(z)
        ch, sh = (grown + 1 / grown) / 2, (grown - 1 / grown) / 2
        one, two = (ch + c) / 2, (sh + s) / (2 * b)
        three, four = (ch - c) / (2 * b**2), (sh - s) / (2 * b**3)
        k = b**4
        kfour, kthree = k * four, k * three
        return matrix([[one, two, three / EI, -four / EI], [kfour, one, two / EI, -three / EI],
                       [kthree * EI, kfour * EI, one, -two], [-k * two * EI, -kthree * EI, -kfour, one]])
    return at


def point(order, impedance, rotary=lambda w: 0):
    """w -> transfer over a place with force impedance(w) u and moment rotary(w) u' on it: k - w^2 m and its like."""
    def at(w):
        found = matrix([[int(i == j) for j in range(order)] for i in range(order)])
        if order == 2:
            found[1, 0] = impedance(w)
        else:
            found[3, 0], found[2, 1] = impedance(w), rotary(w)
        return found
    return at


def mass(order, m, J=0):
    """A point with inertia."""
    return point(order, lambda w: -m * w**2, lambda w: -J * w**2)


def spring(order, k, kt=0):
    """A point with springs to the ground."""
    return point(order, lambda w: k, lambda w: kt)


HELD = {"clamped": (0, 1), "pinned": (0, 2), "guided": (1, 3), "free": (2, 3)}


def condition(parts, left, right):
    """w -> the determinant that vanishes at natural frequencies; parts from left to right."""
    def at(w):
        order = parts[0](w).rows
        held = HELD if order == 4 else {"clamped": (0,), "free": (1,)}
        whole = matrix([[int(i == j) for j in range(order)] for i in range(order)])
        for part in parts:
            whole = part(w) * whole
        rows, columns = held[right], [i for i in range(order) if i not in held[left]]
        found = matrix([[whole[i, j] for j in columns] for i in rows])
        return det(found) if found.rows > 1 else found[0, 0]
    return at


def first_roots(function, count, step, start=None):
    """The first zeros by a scan in steps well below their distance."""
    found, x = [], mpf(start if start is not None else step / 7)
    here = function(x)
    while len(found) < count:
        there = function(x + step)
        if here * there < 0:
            found.append(findroot(function, (x, x + step), "anderson"))
        x, here = x + step, there
    return found
