"""By which method the eigenvalues of a system are found: the ladder, from what it is and how many coordinates it has.

    K, velocities                            form            all certified up to    if sure    in floats
    symmetric, none                          SQUARES         CERTIFIED              – 120      beyond
    not symmetric, none                      FOLLOWER        CERTIFIABLE                       beyond
    massless coordinates held by dampers     FIRST_ORDER     CERTIFIED              – 80       beyond, refused
    not symmetric, any                       FIRST_ORDER     CERTIFIABLE                       beyond
    symmetric, any                           MODAL           CERTIFIED              – 80       beyond

SQUARES: K x = ω² M x. FOLLOWER: the same with a K that is not symmetric. MODAL: λ² + λ C + ω² in the modes without
damping. FIRST_ORDER: places and velocities of what has inertia, places of what has none. Certified: enclosed in fixed
point; if sure: in floats as long as their bound is below ENOUGH, and of damped ones that of Re λ below FAINT, else
certified. Of more coordinates than dense matrices are made of, the lowest natural modes alone are found
(lowest_modes.py).
"""

from typing import Any

from vibcli.base.named_tuple import NamedTuple

CERTIFIED, CERTIFIABLE, CERTIFIABLE_SQUARES = 40, 80, 120
SQUARES, FOLLOWER, FIRST_ORDER, MODAL = "squares", "follower", "first order", "modal"
IN_DIGITS, ENCLOSED, IF_SURE, IN_FLOATS = "in digits", "enclosed", "if sure", "in floats"


class Method(NamedTuple):
    """form: of the eigenvalue problem; arithmetic: in which it is solved."""

    form: str
    arithmetic: str


def choose(elements: Any, digits: int | None = None) -> Method:
    """The Method for the eigenvalues of a system; digits: how many are asked for, None: those of floats."""
    form = form_of(elements)
    certifiable = CERTIFIABLE_SQUARES if form == SQUARES else CERTIFIABLE
    if digits is not None:
        return Method(form, IN_DIGITS)
    if elements.n <= (certifiable if elements.circulatory else CERTIFIED):
        return Method(form, ENCLOSED)
    return Method(form, IN_FLOATS if elements.n > certifiable else IF_SURE)


def form_of(elements: Any) -> str:
    """The form of the eigenvalue problem of a system."""
    if not damped_at_all(elements) and not any(elements.G.values()):
        return FOLLOWER if elements.circulatory else SQUARES
    return FIRST_ORDER if elements.circulatory or dragged(elements) else MODAL


def damped_at_all(elements: Any) -> bool:
    """Does anything depend on velocities but gyroscopic terms?"""
    return any(c for c, _ in elements.dampers) or any(elements.C.values())


def dragged(elements: Any) -> list[int]:
    """The massless coordinates that a damper touches."""
    if not elements.massless:
        return []
    touched = {i for c, row in elements.dampers if c for i, x in row.items() if x}
    touched.update(i for matrix in (elements.C, elements.G) for at, x in matrix.items() if x for i in at)
    return sorted(touched.intersection(elements.massless))
