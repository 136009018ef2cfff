"""Long lengths under a root get a symbol of their own, ℓ₁ = √(…), so that equations stay readable."""

from vibcli.algebra.expression import HALF, ONE

SHORT = 2           # roots of fewer terms are left in place


def abbreviated(table, nodes):
    """(nodes with long roots replaced, [(symbol, root)])."""
    roots = {}
    for node in nodes:
        for base in _rooted(node):
            roots.setdefault(base, None)
    if not roots:
        return nodes, []
    for i, base in enumerate(roots, 1):
        roots[base] = table.parameter(f"ℓ{i}")
    shown = [_replaced(table, node, roots) for node in nodes]
    return shown, [(symbol, table.power(base, HALF)) for base, symbol in roots.items()]


def _rooted(node):
    """The long sums that stand under a root anywhere in a node."""
    pending, found = [node], []
    while pending:
        part = pending.pop()
        if part.op == "product":
            found += [base for base, e in part.args if base.op == "sum" and base.mask and e.denominator == 2
                      and len(base.args) >= SHORT]
        if part.op in ("sum", "product"):
            pending.extend(arg for arg, _ in part.args)
        elif part.op == "call":
            pending.extend(part.args)
    return sorted(found, key=lambda base: base.index)


def _replaced(table, node, roots):
    """The node with each Σ^(e) of a long root written as ℓ^(2e)."""
    if node.op == "sum":
        return table.sum((table.number(node.coefficient), ONE), *((_replaced(table, part, roots), c) for part, c in node.args))
    if node.op == "product":
        factors = []
        for base, e in node.args:
            if base in roots:
                factors.append((roots[base], 2 * e))
            else:
                factors.append((_replaced(table, base, roots), e))
        return table.product((table.number(node.coefficient), ONE), *factors)
    return roots[node] ** 2 if node in roots else node
