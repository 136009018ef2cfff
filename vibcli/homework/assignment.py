"""Who gets what: each student the first variant that is still free in a permutation of their own.

The permutations are made of hashes of salt, problem, student and attempt, so that a student who is added at the end of
a roster changes nobody's sheet, and no random stream is kept.
"""

from collections.abc import Callable, Iterator, Sequence
from hashlib import blake2b
from itertools import islice
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from vibcli.homework.course import CoursePart, CourseProblem
    from vibcli.homework.roster import Student

POOL = "a pool"         # in place of a student: no id has a blank

def assigned(salt: bytes, problem: str, students: "Sequence[Student]", count: int, attempt: int = 1,
             suits: "Callable[[Student, int], bool]" = lambda student, number: True) -> list[int]:
    """The number of the variant, from 0, of each student: none share while there are free ones, and each suits where a
    free one does."""
    found: list[int] = []
    taken: set[int] = set()
    for student in students:
        if len(taken) == count:
            taken = set()
        order = _permutation(salt, problem, student.id, attempt, count)
        first = next(i for i in order if i not in taken)
        place = first if suits(student, first) else next((i for i in order if i not in taken and suits(student, i)),
                                                         first)
        taken.add(place)
        found.append(place)
    return found


def picked(salt: bytes, number: int, part: "CoursePart", student: "Student", attempt: int = 1) -> "list[CourseProblem]":
    """The problems of a part that a student gets, in its order."""
    order = _permutation(salt, f"part {number}", student.id, attempt, len(part.problems))
    chosen = sorted(next(order) for _ in range(part.pick))
    return [part.problems[i] for i in chosen]


def pooled(salt: bytes, problem: str, count: int, wanted: int, attempt: int = 1,
           suits: "Callable[[int], bool]" = lambda number: True) -> list[int]:
    """The numbers, from 0 and upwards, of so many variants that suit, which others hand out; fewer where no more do."""
    return sorted(islice(filter(suits, _permutation(salt, problem, POOL, attempt, count)), wanted))


def _permutation(salt: bytes, problem: str, student: str, attempt: int, count: int) -> Iterator[int]:
    """The numbers below `count` in the order in which hashes name them."""
    seen: set[int] = set()
    seed = b"\0".join(part.encode() if isinstance(part, str) else part
                      for part in (salt, problem, student, str(attempt)))
    number = 0
    while len(seen) < count:
        found = int.from_bytes(blake2b(seed + b"\0" + number.to_bytes(8, "big")).digest(), "big") % count
        number += 1
        if found not in seen:
            seen.add(found)
            yield found
