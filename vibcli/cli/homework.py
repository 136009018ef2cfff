"""`vibcli homework SET -o FOLDER --students roster.csv --salt-file F`: sheets for students, keys for who marks them."""

import os
from collections import Counter
from collections.abc import Sequence
from pathlib import Path
from typing import TYPE_CHECKING

import click

from vibcli.base.diagnostics import escaped
from vibcli.base.enumeration import amount
from vibcli.base.errors import Diagnostic, PhysicsError, SpecError, Where
from vibcli.cli.common import color_option, patience_option, problem_in, source_of
from vibcli.cli.pictures import refused_as_usage
from vibcli.cli.workers import worker_options, workers
from vibcli.homework.exports import FORMATS

if TYPE_CHECKING:
    from concurrent.futures import Executor

    from vibcli.homework.course import Course, CourseProblem
    from vibcli.homework.handout import Handout
    from vibcli.homework.manifest import Assigned
    from vibcli.homework.parts import BegunVariants
    from vibcli.homework.roster import Student

LEAST_SALT = 8      # characters


@click.command("homework")
@click.argument("course", metavar="SET", type=click.Path())
@click.option("-o", "--output", "folder", required=True, metavar="FOLDER", type=click.Path(path_type=Path),
              help="The folder to write, new or empty.")
@click.option("--students", metavar="FILE", help="The roster: a CSV file with a heading, id and perhaps name.")
@click.option("--paper", type=click.IntRange(1, 100_000), metavar="N", help="N numbered sheets without names instead.")
@click.option("--export", "formats", multiple=True, type=click.Choice(list(FORMATS)),
              help="A package for a course system, several times for several; with --pool.")
@click.option("--pool", type=click.IntRange(1, 100_000), metavar="N",
              help="N variants of each problem for the packages, instead of students.")
@click.option("--salt-file", metavar="FILE", help="A file with a secret text: who gets which variant hangs on it.")
@click.option("--attempt", type=click.IntRange(1, 1000), default=1, metavar="N", help="Another gives other variants.")
@click.option("--distinct", is_flag=True, help="Refuse where students would share a variant.")
@click.option("--from-manifest", is_flag=True, help="SET is the manifest.json of sheets: write them again.")
@click.option("--force", is_flag=True, help="Replace sheets that the folder holds.")
@worker_options
@patience_option
@color_option
def command(course: str, folder: Path, students: str | None, paper: int | None, formats: Sequence[str],
            pool: int | None, salt_file: str | None, attempt: int, distinct: bool, from_manifest: bool, force: bool,
            jobs: int, cluster: str | None, patience: int) -> int:
    """Hand out a problem, a folder of them or a set.yaml: a sheet for each student, each with values of its own, the
    keys with worked solutions, and a manifest by which `vibcli grade` marks; or a pool of variants as packages for
    course systems. See vibcli explain homework, and vibcli explain exports."""
    from vibcli.homework.folder import refuse_folder

    with refused_as_usage():
        refuse_folder(folder, force)
    if from_manifest:
        if students or paper or distinct or pool or formats:
            raise click.UsageError("--from-manifest knows its students: leave --students, --paper, --distinct, --pool "
                                   "and --export out")
        with workers(jobs, cluster) as executor:
            return _again(course, folder, force, patience, executor)
    if pool or formats:
        _require_pool(pool, formats, students or paper or distinct)
        salt = _salt(salt_file)
        found = _course(course)
        with workers(jobs, cluster) as executor:
            handouts = _handouts(found, patience, executor)
            return _pool(found, handouts, folder, force, salt, pool, list(dict.fromkeys(formats)), attempt, executor)
    if (students is None) == (paper is None):
        raise click.UsageError("say for whom: --students roster.csv, or --paper 30 for numbered sheets")
    salt = _salt(salt_file)
    from vibcli.homework.roster import numbered, roster

    who = numbered(paper) if students is None else roster(students)
    found = _course(course)
    with workers(jobs, cluster) as executor:
        handouts = {one.name: one for one in _handouts(found, patience, executor)}
        assigned = _assigned(salt, found, handouts, who, attempt)
        _tell_shared(handouts, assigned, distinct)
        return _write(folder, force, found, list(handouts.values()), assigned, attempt,
                      salt.decode("utf-8", "replace"), executor)


def _require_pool(pool: int | None, formats: Sequence[str], others: object) -> None:
    """A usage error where packages are not told apart from sheets."""
    if not formats:
        raise click.UsageError(f"--pool is for packages: say for which system, as in --export {next(iter(FORMATS))}")
    if others:
        raise click.UsageError("course systems hand out by themselves: leave --students, --paper and --distinct out, "
                               "and say how many variants they get: --pool 40")
    if not pool:
        raise click.UsageError("say how many variants of each problem the packages hold: --pool 40")


def _pool(course: "Course", handouts: "list[Handout]", folder: Path, force: bool, salt: bytes, count: int,
          formats: list[str], attempt: int, executor: "Executor | None") -> int:
    """Write the first so many variants of each problem, in an order by the salt, as packages."""
    from vibcli.homework.exports.package import of_pool

    numbers = [_pooled(course, one, salt, count, attempt) for one in handouts]
    for one, those in zip(handouts, numbers, strict=True):
        if len(those) < count:
            named = " that by chance tell no key of their own" * (len(those) < one.accepted)
            raise PhysicsError(f"{one.name} has {amount(len(those), 'variant')}{named}, and a pool of {count} is asked "
                               "for", f"ask for --pool {min(map(len, numbers))}, or widen the ranges", one.rules.where)
    assigned = [sheet for one, those in zip(handouts, numbers, strict=True) for sheet in of_pool(one, those)]
    return _write_pool(folder, force, course, handouts, assigned, attempt, salt.decode("utf-8", "replace"), formats,
                       executor)


def _pooled(course: "Course", handout: "Handout", salt: bytes, count: int, attempt: int) -> list[int]:
    """The numbers of the variants of a pool: none whose item would by chance tell a key of it; where all do, any, which
    are refused with that."""
    from vibcli.homework.assignment import pooled
    from vibcli.homework.coincidences import Coincidences
    from vibcli.homework.exports.item import item_of

    coincidences = Coincidences()

    def suits(number: int) -> bool:
        words = f"{course.title} ; {course.course} ; {course.due} ; {item_of(handout.name, number)}"
        return not coincidences.found(words, (), handout, number)

    return (pooled(salt, handout.name, handout.accepted, count, attempt, suits)
            or pooled(salt, handout.name, handout.accepted, count, attempt))


def _write_pool(folder: Path, force: bool, course: "Course", handouts: "list[Handout]", assigned: "Assigned",
                attempt: int, salt: str, formats: Sequence[str], executor: "Executor | None") -> int:
    from vibcli.homework.exports.package import pool_files
    from vibcli.homework.folder import write_folder
    from vibcli.homework.paper import paper

    on = paper()
    with handouts[0].base.work.task("the packages") as task:
        found = pool_files(course, handouts, assigned, attempt, salt, formats, on, task.step, executor)
        count = write_folder(folder, found, force)
    click.echo(f"{len(assigned)} variants of {len(handouts)} problem{'s' * (len(handouts) > 1)} for "
               f"{', '.join(formats)}: {count} files in {escaped(os.fspath(folder))}")
    for one in handouts:
        if by_hand := one.by_hand:
            click.echo(f"{escaped(one.name)}: {', '.join(by_hand)}: marked by hand, "
                       "since no system compares expressions")
    return 0


def _salt(path: str | None) -> bytes:
    """The secret text; a usage error where there is none."""
    if path is None:
        raise click.UsageError("name a file with a secret text: --salt-file FILE; keep it, so that a student who is "
                               "added later changes nobody's sheet")
    try:
        found = Path(path).read_bytes().strip()
    except OSError as error:
        raise click.UsageError(f"the salt cannot be read: {error.strerror}") from None
    if len(found) < LEAST_SALT:
        raise click.UsageError(f"the salt is shorter than {LEAST_SALT} characters: it could be guessed")
    return found


def _course(path: str) -> "Course":
    from vibcli.homework.course import course_of

    try:
        return course_of(path)
    except FileNotFoundError:
        raise click.UsageError(f"there is no file or folder '{path}'") from None


def _handouts(course: "Course", patience: int, executor: "Executor | None") -> "list[Handout]":
    """The Handouts of its problems, all variants solved; with an executor several problems at a time."""
    from vibcli.homework.handout import Handout
    from vibcli.homework.refusals import require_variants

    begun = [(one, *_begun(one, patience, executor)) for one in course.problems]
    handouts = []
    for one, text, under_way in begun:
        found = under_way.solved()
        require_variants(found, under_way.document)
        handouts.append(Handout.of(one, found, under_way.document, text))
    return handouts


def _begun(one: "CourseProblem", patience: int, executor: "Executor | None") -> "tuple[str, BegunVariants]":
    """(text of its file, its variants under way)."""
    from vibcli.api import given
    from vibcli.homework.document import SceneDocument
    from vibcli.homework.parts import begin_variants

    source = source_of(one.path)
    problem = problem_in(source, (), patience)
    if one.case is not None:
        try:
            problem = given.case(problem, one.case)
        except ValueError as error:
            raise SpecError([Diagnostic(one.where or Where(one.path, 1, 1, 0), f"{one.path}: {error}")]) from None
    if problem.spec.get("variants") is None:
        raise SpecError([Diagnostic(Where(one.path, 1, 1, 0), "this scene says nothing of variants",
                                    "give values under variants: parameters")])
    document = SceneDocument.of(source.node, source.file, one.case)
    return "\n".join(source.lines), begin_variants(problem, document, executor)


def _tell_shared(handouts: "dict[str, Handout]", assigned: "Assigned", distinct: bool) -> None:
    """Say where students share variants; refused where they must not."""
    for name, handout in handouts.items():
        given = Counter(number for _, sheets in assigned for one, number in sheets if one is handout)
        if (most := max(given.values(), default=0)) > 1:
            said = f"{name}: {given.total()} students, {amount(handout.accepted, 'variant')}: up to {most} share one"
            if distinct:
                raise PhysicsError(said, "widen the ranges of its variants", handout.rules.where)
            click.echo(escaped(said), err=True)


def _assigned(salt: bytes, course: "Course", handouts: "dict[str, Handout]", students: "Sequence[Student]",
              attempt: int) -> "Assigned":
    """(student, (problem, number of the variant) in order) of each."""
    from vibcli.homework.assignment import assigned, picked
    from vibcli.homework.coincidences import Coincidences

    chosen = {student.id: [one.name for number, part in enumerate(course.parts)
                           for one in picked(salt, number, part, student, attempt)] for student in students}
    found: dict[str, dict[str, int]] = {student.id: {} for student in students}
    coincidences = Coincidences()
    for name, handout in handouts.items():
        def suits(student: "Student", number: int, handout: "Handout" = handout) -> bool:
            taken = [(handouts[other], given) for other, given in found[student.id].items()]
            words = f"{course.title} ; {course.course} ; {course.due} ; {student.name} ; {student.id}"
            return not coincidences.found(words, taken, handout, number)

        who = [student for student in students if name in chosen[student.id]]
        for student, number in zip(who, assigned(salt, name, who, len(handout.variants), attempt, suits), strict=True):
            found[student.id][name] = number
    return [(student, [(handouts[name], found[student.id][name]) for name in chosen[student.id]])
            for student in students]


def _write(folder: Path, force: bool, course: "Course", handouts: "list[Handout]", assigned: "Assigned", attempt: int,
           salt: str, executor: "Executor | None") -> int:
    from vibcli.homework.folder import files, write_folder
    from vibcli.homework.paper import paper

    on = paper()
    work = handouts[0].base.work
    with work.task("the sheets") as task:
        found = files(course, handouts, assigned, attempt, salt, on, task.step, executor)
        count = write_folder(folder, found, force)
    shared = sum(one.accepted for one in handouts)
    click.echo(f"{amount(len(assigned), 'sheet')} of {amount(len(handouts), 'problem')} with "
               f"{amount(shared, 'variant')}: {count} files in {escaped(os.fspath(folder))}")
    if on.suffix != ".pdf":
        click.echo("They are HTML pages; PDF needs the extra homework: pip install 'vibcli[homework]'")
    return 0


def _again(path: str, folder: Path, force: bool, patience: int, executor: "Executor | None") -> int:
    """Write the sheets of a manifest again."""
    from vibcli.homework.handed_out import handed_out
    from vibcli.homework.manifest import read_manifest

    manifest = read_manifest(path)
    course, handouts, assigned, attempt = handed_out(manifest, patience)
    if formats := [one["format"] for one in manifest.get("exports", ())]:
        return _write_pool(folder, force, course, handouts, assigned, attempt, "", formats, executor)
    return _write(folder, force, course, handouts, assigned, attempt, "", executor)
