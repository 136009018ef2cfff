"""Entries put into a mapping of a file: the rest of it stays letter by letter, and both read as one."""

import pytest
import yaml

from vibcli.language.document.insertion import with_entries

ADDED = {"omega[1]": "20.0 rad/s", "motion[x]": "m*x'' + k*x = 0"}
LINES = "  omega[1]: 20.0 rad/s\n  motion[x]: m*x'' + k*x = 0\n"


def inserted(text, path=("answers",), entries=ADDED):
    """The text with entries, read back: all that was there, and them."""
    found = with_entries(text, path, entries, "cases")
    before, after = yaml.safe_load(text), yaml.safe_load(found)
    for key in path[:-1]:
        before, after = before[key], after[key]
    assert after == {**before, path[-1]: {**(before.get(path[-1]) or {}), **entries}}
    return found


@pytest.mark.parametrize("text, expected", [
    ("a: 1\n", "a: 1\nanswers:\n" + LINES),
    ("a: 1", "a: 1\nanswers:\n" + LINES),
    ("a: 1   # kept\n# below\n", "a: 1   # kept\nanswers:\n" + LINES + "# below\n"),
    ("# top\nanswers:\n  # why\n  zeta[1]: 0.1  # known\n\n# then\na: 1\n",
     "# top\nanswers:\n  # why\n  zeta[1]: 0.1  # known\n" + LINES + "\n# then\na: 1\n"),
    ("answers:\n    zeta[1]: {value: 0.1, rtol: 1 %}\na: 1\n",
     "answers:\n    zeta[1]: {value: 0.1, rtol: 1 %}\n" + LINES.replace("  o", "    o").replace("  m", "    m")
     + "a: 1\n"),
    ("a: 1\n# of cases\ncases:\n  heavy: {b: 2}\n",
     "a: 1\nanswers:\n" + LINES + "# of cases\ncases:\n  heavy: {b: 2}\n"),
    ("a: >-\n  long\n  text\n\nb:\n- 1\n- 2\n", "a: >-\n  long\n  text\n\nb:\n- 1\n- 2\nanswers:\n" + LINES),
    ("a: |\n  long\n  text\n", "a: |\n  long\n  text\nanswers:\n" + LINES),
    ("a: |\n  long\n\n# end\n", "a: |\n  long\n\nanswers:\n" + LINES + "# end\n"),
    ("a: one\n  two\n", "a: one\n  two\nanswers:\n" + LINES),
    ("---\na: 1\n...\n", "---\na: 1\nanswers:\n" + LINES + "...\n"),
    ("a: 1\r\nb: 2\r\n", "a: 1\r\nb: 2\r\nanswers:\r\n" + LINES.replace("\n", "\r\n")),
    ("α: ½ # µ\nanswers: {zeta[1]: 1}\n".replace("zeta[1]", '"zeta[1]"'),
     'α: ½ # µ\nanswers: {"zeta[1]": 1, "omega[1]": "20.0 rad/s", "motion[x]": "m*x\'\' + k*x = 0"}\n'),
    ("{a: 1}", '{a: 1, "answers": {"omega[1]": "20.0 rad/s", "motion[x]": "m*x\'\' + k*x = 0"}}'),
    ("{\n  a: 1,\n}\n", '{\n  a: 1, "answers": {"omega[1]": "20.0 rad/s", "motion[x]": "m*x\'\' + k*x = 0"}}\n'),
])
def test_what_is_added_stands_last_and_the_rest_as_it_was(text, expected):
    assert inserted(text) == expected


@pytest.mark.parametrize("text, expected", [
    ("a: 1\ncases:\n  heavy:\n    b: 2\n  light: {b: 3}\n",
     "a: 1\ncases:\n  heavy:\n    b: 2\n    answers:\n" + LINES.replace("  o", "      o").replace("  m", "      m")
     + "  light: {b: 3}\n"),
    ("a: 1\ncases:\n  heavy: {b: 2}  # so\n",
     'a: 1\ncases:\n  heavy: {b: 2, "answers": {"omega[1]": "20.0 rad/s", "motion[x]": "m*x\'\' + k*x = 0"}}  # so\n'),
    ("a: 1\ncases: {heavy: {b: 2,}, light: {b: 3}}\n",
     'a: 1\ncases: {heavy: {b: 2, "answers": {"omega[1]": "20.0 rad/s", "motion[x]": "m*x\'\' + k*x = 0"}}, '
     'light: {b: 3}}\n'),
])
def test_what_is_added_to_a_case_stands_in_it(text, expected):
    assert inserted(text, ("cases", "heavy", "answers")) == expected
