"""Functions of place and time as sums of products f(x)·g(t)."""

from support.trees import new_table

from vibcli.symbolic.evaluation import Floats, evaluate
from vibcli.symbolic.separated_products import products_of


def test_forms_in_proportion_are_one():
    """(3x² + 6q)(1 + 4 cos t) + 5x cos t: two forms, though three products without like g."""
    table = new_table()
    x, t, q = table.variable("x"), table.variable("t"), table.parameter("q")
    wave = table.call("cos", t)
    node = (3 * x * x + 6 * q) * (1 + 4 * wave)
    (along, moving), = products_of(node, x, t)
    values = {"x": 0.7, "t": 0.4, "q": 1.3}
    assert evaluate([along * moving - node], Floats, values)[0] == 0
    assert not along.mask & t.mask and not moving.mask & x.mask
    assert len(products_of(node + 5 * x * wave, x, t)) == 2
    assert products_of(table.call("exp", x * t), x, t) is None
