"""How the frequency of free motions hangs on their amplitude, and where two equilibria meet as a parameter changes."""

from vibcli.quantities.quantity import SIGNAL, Declaration, as_asked, rounded


def _backbone(problem, tree, args):
    return problem.free_motions.omega(int(tree.indices[0]), tree.args[0], args[1])


def _fold(problem, tree, args):
    found = problem.limit_loads(tree.indices[1]).limit_point(int(tree.indices[0]))
    return as_asked(problem, found.value), rounded(problem, found.error)


def _at_fold(problem, tree, args):
    value, error = problem.limit_loads(tree.indices[1]).at_limit_point(int(tree.indices[0]), tree.args[0])
    return as_asked(problem, value), rounded(problem, error)


QUANTITIES = {
    "backbone": Declaration(
        "angular frequency of the free motion of family i in which a signal has this amplitude, half its range, about "
        "the equilibrium; dampers and loads in time are left out", "rad/s", _backbone, ("number",),
        ("signal", "amplitude"), several=True),
    "fold": Declaration(
        "value of a parameter p at which two equilibria meet and vanish (limit point, limit load, snap-through): the "
        "k-th of those that the equilibrium passes when it is followed as p grows and falls, by ascending |p|, equal "
        "ones once; of the sign that p has, of both signs where p has `sign: any`; branchings, where equilibria cross, "
        "are no folds; fold[1, p](x) is the coordinate or signal x there", None, _fold, ("number", "parameter"),
        several=True, dimension=lambda spec, tree: spec.dimensions.of(tree.indices[1])),
    "fold()": Declaration(
        "a coordinate or signal in the equilibrium of that fold", SIGNAL, _at_fold, ("number", "parameter"),
        ("signal",), several=True),
}
