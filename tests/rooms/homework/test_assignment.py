"""Who gets what: permutations by hashes, nobody moved by who comes later, nobody sharing while variants last."""

from collections import Counter

import pytest

from vibcli.base.errors import SpecError
from vibcli.homework.assignment import assigned, picked
from vibcli.homework.course import CoursePart, CourseProblem, course_of
from vibcli.homework.roster import Student, numbered, roster

SALT = b"a secret text"


def test_no_two_share_while_variants_last():
    students = numbered(60)
    found = assigned(SALT, "crank", students, 60)
    assert sorted(found) == list(range(60))
    assert max(Counter(assigned(SALT, "crank", students, 25)).values()) == 3
    assert sorted(Counter(assigned(SALT, "crank", students, 25)).values()) == [2] * 15 + [3] * 10


def test_who_is_added_at_the_end_changes_nobody():
    students = [Student(f"s{i}") for i in range(40)]
    found = assigned(SALT, "crank", students, 100)
    assert assigned(SALT, "crank", [*students, Student("late")], 100)[:40] == found


def test_what_does_not_suit_is_passed_over_and_nobody_shares_for_it():
    students = numbered(10)
    plain = assigned(SALT, "crank", students, 12)
    fourth = students[3], plain[3]
    found = assigned(SALT, "crank", students, 12, 1, lambda student, number: (student, number) != fourth)
    assert found[:3] == plain[:3] and found[3] != plain[3] and len(set(found)) == 10
    assert assigned(SALT, "crank", students, 12, 1, lambda student, number: False) == plain


def test_salt_problem_and_attempt_change_all():
    students = numbered(30)
    first = assigned(SALT, "crank", students, 1000)
    for other in (assigned(b"another secret", "crank", students, 1000), assigned(SALT, "lever", students, 1000),
                  assigned(SALT, "crank", students, 1000, 2)):
        assert sum(a == b for a, b in zip(first, other, strict=True)) <= 3


def test_the_same_on_every_machine():
    assert assigned(SALT, "crank", numbered(6), 50) == PINNED


PINNED = [18, 12, 5, 10, 11, 33]


def test_problems_that_are_picked():
    part = CoursePart(tuple(CourseProblem(name, name) for name in "abcde"), 2)
    found = [tuple(one.name for one in picked(SALT, 0, part, student)) for student in numbered(40)]
    assert all(len(set(one)) == 2 and list(one) == sorted(one) for one in found)
    assert len(set(found)) > 5
    assert found[:10] == [tuple(one.name for one in picked(SALT, 0, part, student)) for student in numbered(40)[:10]]


@pytest.mark.parametrize("text, said", [
    ("name\nAda\n", "one of them is 'id'"), ("id\ns1\ns1\n", "stands in line 2 already"),
    ("id,name\n,Ada\n", "has no id"),
    ("id\n=1+1\n", "would be a formula"), ("id\na b\n", "is no id"), ("id\n", "no student"),
    ("", "one of them is 'id'"),
    ("id\nS1\ns1\n", "stands in line 2 already"), ("id\n../x\n", "is no id"),
    ('id,name\ns1,"Ada\ns2,Bo\n', "cannot be read"), ('id,name\ns1,"Ada\ns2,Bo"\n', "is no name"),
    ("id,name\ns1,A\0da\n", "is no name"), (f"id,name\ns1,{'x' * 201}\n", "is no name"),
    (f"id,name\ns1,{'x' * 10_000_000}\n", "cannot be read"), ('id,name\ns1,"A" B\n', "cannot be read")])
def test_rosters_that_are_none(tmp_path, text, said):
    path = tmp_path / "roster.csv"
    path.write_text(text, encoding="utf-8")
    with pytest.raises(SpecError) as error:
        roster(str(path))
    assert said in error.value.diagnostics[0].message


def test_a_line_of_a_roster_is_shown_with_its_id(tmp_path):
    path = tmp_path / "roster.csv"
    path.write_text("name,id\nAda,s1\n\nBo,s1\n,=1\n", encoding="utf-8")
    with pytest.raises(SpecError) as error:
        roster(str(path))
    assert [one.where[1:] for one in error.value.diagnostics] == [(4, 4, 2), (5, 2, 2)]


def test_rosters(tmp_path):
    path = tmp_path / "roster.csv"
    path.write_bytes("\ufeffName;ID\nÄda;s1\n;s2\n\n".encode())
    assert roster(str(path)) == [Student("s1", "Äda"), Student("s2", "")]
    path.write_text("id\tname\ns1\t=1+1\ns2\t\"A \"\"B\"\" C\"\n")
    assert roster(str(path)) == [Student("s1", "=1+1"), Student("s2", 'A "B" C')]
    path.write_bytes(b"id\n\xff\n")
    with pytest.raises(SpecError, match="UTF-8"):
        roster(str(path))


@pytest.mark.parametrize("text, said", [
    ("problems: [{file: none.yaml}]", "there is no file 'none.yaml'"), ("title: x", "needs 'problems'"),
    ("problems: [{file: a.yaml}, {file: a.yaml}]", "stands twice"), ("problems: [{fil: a.yaml}]", "unknown key 'fil'"),
    ("problems: [{file: a.yaml}, {file: caps/A.yaml}]", "'a' and 'A' differ in capitals alone"),
    ("problems: [{file: a.yaml, pick: 2}]", "'pick' is for a folder"),
    ("problems: [{file: more, pick: 3}]", "this folder has 1 problem"),
    ("problems: [{file: /etc/x.yaml}]", "by its way")])
def test_sets_that_are_none(tmp_path, text, said):
    (tmp_path / "a.yaml").write_text("title: a\n")
    for name in ("more/b", "caps/A"):
        (tmp_path / name).parent.mkdir()
        (tmp_path / f"{name}.yaml").write_text("title: b\n")
    (tmp_path / "set.yaml").write_text(text + "\n")
    with pytest.raises(SpecError) as error:
        course_of(str(tmp_path / "set.yaml"))
    assert said in error.value.diagnostics[0].message


def test_sets(tmp_path):
    (tmp_path / "a.yaml").write_text("title: a\n")
    (tmp_path / "more").mkdir()
    for name in "bcd":
        (tmp_path / "more" / f"{name}.yaml").write_text("title: b\n")
    (tmp_path / "set.yaml").write_text("title: Week 3\ncourse: Dynamics\ndue: Friday\n"
                                       "problems: [a.yaml, {file: more, pick: 2, points: 4}]\n")
    found = course_of(str(tmp_path))
    assert (found.title, found.course, found.due) == ("Week 3", "Dynamics", "Friday")
    assert [one.name for one in found.problems] == ["a", "b", "c", "d"] and found.parts[1].pick == 2
    assert course_of(str(tmp_path / "more")).parts[0].pick == 3
    assert course_of(str(tmp_path / "a.yaml")).problems[0].name == "a"
