"""How the frequency of free motions hangs on their amplitude."""

from vibcli.quantities.quantity import Declaration


def _backbone(problem, tree, args):
    return problem.free_motions.omega(int(tree.indices[0]), tree.args[0], args[1])


QUANTITIES = {
    "backbone": Declaration(
        "angular frequency of the free motion of family i in which a signal has this amplitude, half its range, about "
        "the equilibrium; dampers and loads in time are left out", "rad/s", _backbone, ("number",),
        ("signal", "amplitude"), several=True),
}
