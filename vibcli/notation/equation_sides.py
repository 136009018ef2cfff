"""The two sides of an equation as a textbook writes it: what depends on the time alone stands on the right."""

from vibcli.symbolic.rationals import ONE


def sides(scene, node):
    """(left, right) of node = 0."""
    time = scene.time.mask
    if node.op != "sum" or not node.mask & time:
        return node, scene.table.zero
    driving = [(part, -c) for part, c in node.args if part.mask & time and not part.mask & ~time]
    if len(driving) == len(node.args):
        return node, scene.table.zero
    right = scene.table.sum(*driving)
    return scene.table.sum((node, ONE), (right, ONE)), right


def equation(scene, node, write):
    """node = 0 as text."""
    left, right = sides(scene, node)
    return f"{write(left)} = {write(right)}"
