"""One degree of freedom in letters: ω² = K/M, ζ = C/(2√(K M)), and the damper that makes ζ = 1. Without SymPy."""

from vibcli.algebra.expression import reachable
from vibcli.algebra.quotient import single
from vibcli.algebra.rationals import ONE
from vibcli.algebra.roots import root
from vibcli.analyses.letters.forms import ClosedForms, ClosedMode
from vibcli.analyses.letters.samples import confirmed, damping_confirmed, samples, squares


def one_degree(problem, M, C, K):
    """The ClosedForms of a scene with one coordinate; None where they do not hold."""
    table = problem.scene.table
    candidates = [] if M.is_zero else samples(problem)
    if not candidates:
        return None
    values = [candidate.floats for candidate in candidates]
    square = single(K / M)
    unstable = squares(candidates[0])[0] < 0
    mode = ClosedMode(square, root(-square if unstable else square, values), [table.one], unstable=unstable)
    if not confirmed([mode], (), candidates):
        return None
    if C.is_zero or K.is_zero or unstable:
        return ClosedForms([mode])
    mode.zeta = damping_ratio(M, C, K, values)
    mode.omega_d = root(single(square - C * C / (4 * M * M)), values)
    if not damping_confirmed([mode], candidates):
        mode.zeta = None
        return ClosedForms([mode])
    return ClosedForms([mode], critical=critical(problem.scene, M, C, K, values))


def damping_ratio(M, C, K, values):
    """ζ = C/(2√(K M))."""
    return single(C) / (2 * root(single(K * M), values))


def critical(scene, M, C, K, values):
    """(c, 2√(K M)/(C/c)) where all dampers have the coefficient c, else None."""
    table, letters = scene.table, {term.weight for term in scene.dampers}
    if len(letters) != 1:
        return None
    letter, = letters
    shape = single(C / letter) if letter.op == "symbol" else letter
    if letter in reachable([shape]):
        return None
    return letter, table.product((table.number(2), ONE), (root(single(K * M), values), ONE), (shape, -ONE))
