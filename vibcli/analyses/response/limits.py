"""What a motion comes to rest at."""

import math

import numpy as np

from vibcli.errors import PhysicsError

NOTHING = 1e-13


def final(motion, output):
    """The limit of the output as t → ∞; PhysicsError where it keeps vibrating, drifts or grows."""
    if motion.forcing.period is not None:
        raise PhysicsError("the load is periodic: the motion comes to no rest",
                           hint="ask for steady(…), mean(…) or a value at a time")
    terms = motion.pieces(math.inf).terms(output, 0)
    parts = terms.on(terms.count - 1)
    scale = sum(abs(factor * _size(nodes)) for nodes, factor in parts)
    total = 0.0
    for nodes, factor in parts:
        if abs(factor * _size(nodes)) > NOTHING * scale:
            total += np.real(factor * limit(nodes))
    return float(total)


def _size(nodes):
    """A measure of E[nodes], for telling what is only rounding: the product of the times of all nodes but one."""
    rates = sorted(abs(node) for node in nodes if node)
    return 1.0 / math.prod(rates[:len(nodes) - 1]) if rates else 1.0


def limit(nodes):
    """lim E[nodes](t): Π 1/(−λ) over the others where one node is zero and the others decay."""
    zeros = sum(not node for node in nodes)
    if any(node.real > 0 for node in nodes):
        raise PhysicsError("the motion grows without end: it comes to no rest", hint="ask for a value at a time")
    if any(node and not node.real for node in nodes):
        raise PhysicsError("the motion keeps vibrating: it comes to no rest",
                           hint="ask for steady(…), mean(…) or a value at a time, or add a damper")
    if zeros > 1:
        raise PhysicsError("the motion drifts without end: it comes to no rest", hint="ask for a value at a time")
    return np.prod([-1 / node for node in nodes if node]) if zeros else 0.0
