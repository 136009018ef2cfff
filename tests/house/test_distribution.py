"""Which tests one process does where several share them: those that share what is solved, the house, those of a file;
first of all those that fork."""

from collections import OrderedDict
from unittest.mock import Mock

from support.distribution import FORKS, Together, unit_of


def test_what_shares_solved_problems_is_done_together():
    sharing = {unit_of(f"tests/{file}::test_it") for file in (
        "derivations/test_derivations.py", "rooms/report/test_steps.py", "commands/test_responses_everywhere.py")}
    assert len(sharing) == 1 and "tests/" not in sharing.pop()
    variants = {unit_of(f"tests/rooms/homework/{file}::test_it[a_stem]") for file in (
        "test_shipped.py", "exports/test_shipped.py")}
    assert len(variants) == 1 and not sharing & variants


def test_a_problem_is_in_the_same_part_for_all():
    stems = ["bar_on_two_springs", "garland_of_power_springs", "two_wells", "chimney_let_go", "plucked_string"]
    for stem in stems:
        assert len({unit_of(f"tests/{file}::test_it[{stem}{more}]", 4) for file, more in (
            ("derivations/test_derivations.py", ""), ("rooms/report/test_steps.py", "-html"))}) == 1
    assert len({unit_of(f"tests/rooms/report/test_steps.py::test_it[{stem}]", 4) for stem in stems}) > 1


def test_files_that_fork_come_first():
    files = "commands/test_processes.py", "commands/test_check_jobs.py", "rooms/homework/test_parts.py"
    assert {unit_of(f"tests/{file}::test_it") for file in files} == {FORKS}
    scheduling, node = Together.__new__(Together), Mock()
    scheduling.workqueue = OrderedDict({"problems 0": {"a": False}, FORKS: {"b": False}, "house": {"c": False}})
    scheduling.assigned_work, scheduling.registered_collections = {}, {node: ["a", "b", "c"]}
    for _ in range(3):
        scheduling._assign_work_unit(node)
    assert [call.args for call in node.send_runtest_some.call_args_list] == [([1],), ([0],), ([2],)]


def test_other_files_are_done_by_themselves():
    assert unit_of("tests/commands/test_work.py::test_one[x]") == "tests/commands/test_work.py"
    assert unit_of("tests/house/test_floors.py::test_one") == unit_of("tests/house/test_figures.py::test_two")
