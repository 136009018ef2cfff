"""The figures of the house: each at most as it stands here, to be lowered whenever it falls."""

from statistics import median

import pytest

from house.measure import main, walks

MOST = {        # methods of House that list or count something
    "arrows": 122,
    "arrows_of_the_plan": 94,
    "floors": 14,
    "taking_problem": 0,
    "set_from_outside": 1,
    "with_several_bases": 1,
}
LONGEST, MIDDLE = 45, 6     # lines of a function
LONGEST_FILE = 300


@pytest.mark.parametrize(("figure", "most"), MOST.items())
def test_no_figure_rises(house, figure, most):
    found = getattr(house, figure)()
    assert (found if isinstance(found, int) else len(found)) <= most


def test_what_is_counted_is_seen(planted):
    house = planted({"mechanics/a.py": "class A(int, B):\n    def f(self, problem, other):\n"
                                       "        self.x = other.x = problem\n",
                     "results/b.py": "from vibcli.mechanics import a\n\n\ndef f(problem):\n    a.y = problem\n"})
    assert house.taking_problem() == ["vibcli.mechanics.a.f"]
    assert house.set_from_outside() == ["vibcli.mechanics.a:3", "vibcli.results.b:5"]
    assert house.with_several_bases() == ["vibcli.mechanics.a.A"]
    assert house.arrows() == {("results", "mechanics")}
    assert house.floors() == 2


def test_functions_are_short(house):
    lengths = house.lengths()
    assert {name: lines for name, lines in lengths.items() if lines > LONGEST} == {}
    assert median(lengths.values()) <= MIDDLE


def test_files_are_short(house):
    lines = {path.name: path.read_bytes().count(b"\n") for path in house.package.rglob("*.py")}
    assert {name: count for name, count in lines.items() if count > LONGEST_FILE} == {}


def test_the_length_of_a_function_is_seen(planted):
    assert planted({"scene/a.py": "@cache\ndef f(x,\n      y):\n    \"\"\"x.\"\"\"\n\n    return x\n"}).lengths() == {
        "vibcli.scene.a.f:2": 5}


@pytest.mark.sweep
def test_a_question_enters_few_rooms_above_the_ground_and_moves_little_between_them():
    (rooms, _, frequencies), (_, _, check) = walks()
    assert len(rooms) <= 12         # with the door, api/
    assert 0 < frequencies < 200 and 0 < check < 250


def test_no_syntax_tree_is_read_by_the_number_of_a_part(house):
    assert house.subscripts() == []


def test_a_subscript_of_a_tree_is_seen(planted):
    assert planted({"scene/a.py": "def f(tree, row):\n    return tree.args[0], row[1], tree[4]\n"}).subscripts() == [
        "vibcli.scene.a:2"]


@pytest.mark.sweep
def test_the_figures_are_printed(house, capsys):
    main(house)
    assert "import circles of files" in capsys.readouterr().out
