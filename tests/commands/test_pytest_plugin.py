"""The plugin of pytest: each answer is a test where the configuration says so, and none elsewhere."""

import subprocess
import sys
import tomllib
from importlib import import_module
from pathlib import Path

import pytest

pytest_plugins = ["pytester"]
RIGHT = """
bodies: {a: {mass: 1 kg, slide: x}}
springs: {s: {k: 4 N/m, between: [ground, a]}}
answers:
  omega[1]: 2 rad/s
  K[x,x]: 4 N/m
cases:
  twice: {bodies: {a: {mass: 4 kg}}, answers: {"omega[1]": 1 rad/s}}
"""
WRONG = RIGHT.replace("2 rad/s", "3 rad/s")


@pytest.fixture
def course(pytester):
    pytester.makeini("[pytest]\nvibcli = true\n")
    pytester.makefile(".yaml", right=RIGHT, wrong=WRONG, slip="bodies: {a: {mas: 1 kg}}\n", bare="title: none\n",
                      **{".pre-commit-config": "repos: []\n"})         # a hidden file is no scene
    return pytester


def ran(course, *args):
    """In a process of its own, as users run it; by its module, as the tree at hand may be another than is installed;
    without other plugins."""
    with pytest.MonkeyPatch.context() as patch:
        patch.setenv("PYTEST_DISABLE_PLUGIN_AUTOLOAD", "1")
        return course.runpytest_subprocess("-p", "vibcli.cli.pytest_plugin", *args)


@pytest.mark.sweep
def test_each_answer_is_a_test_and_the_last_failures_are_known(course):
    found = ran(course, "-v")
    found.assert_outcomes(passed=6, failed=2)
    found.stdout.fnmatch_lines(["*right.yaml::twice: omega[[]1] PASSED*", "*wrong.yaml::omega[[]1] FAILED*",
                                "slip.yaml:1: scene-invalid: *did you mean 'mass'*",
                                "wrong.yaml:4: answer-differs: omega[[]1]: expected 3, found 2*"])
    ran(course, "--lf").assert_outcomes(failed=2)


@pytest.mark.sweep
def test_some_are_chosen_and_the_first_failure_ends_it(course):
    ran(course, "-k", "twice").assert_outcomes(passed=2, deselected=6)
    ran(course, "-x", "right.yaml::K[x,x]", "wrong.yaml").assert_outcomes(passed=1, failed=1)


@pytest.mark.sweep
def test_in_several_processes(course):
    ran(course, "-p", "xdist", "-n", "2").assert_outcomes(passed=6, failed=2)


@pytest.mark.sweep
def test_without_the_setting_nothing_is_collected(pytester):
    pytester.makefile(".yaml", right=RIGHT)
    ran(pytester).assert_outcomes()


@pytest.mark.sweep
def test_pytest_of_others_imports_nothing_of_it(pytester):
    code = ("import sys, vibcli.cli.pytest_plugin; "
            "print(sorted(name for name in sys.modules if name.partition('.')[0] in ('vibcli', 'click', 'yaml')))")
    found = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=True).stdout
    assert found.strip() == "['vibcli', 'vibcli.cli', 'vibcli.cli.pytest_plugin']"


def test_pytest_finds_it_by_its_entry():
    project = tomllib.loads((Path(__file__).parents[2] / "pyproject.toml").read_text())["project"]
    plugin = import_module(project["entry-points"]["pytest11"]["vibcli"])
    assert callable(plugin.pytest_collect_file) and "pytest" in project["optional-dependencies"]
