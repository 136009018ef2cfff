"""A random scene from a seed."""

import random

from . import draw_axis, draw_loads, draw_plane, draw_rare, draw_tied
from .draft import Draft


def drawn(seed):
    """(the draft, its dice) of a seed."""
    dice = random.Random(f"odd {seed}")
    draft = Draft(dice, seed)
    if draft.chance(0.25):
        dice.choice((draw_axis.chain, draw_axis.shaft))(draft)
    elif draft.chance(0.25):
        draw_tied.mechanism(draft)
        if "rotor" not in draft.bodies:
            draw_plane.dressed(draft)
    else:
        draw_plane.machine(draft)
        draw_plane.dressed(draft)
    for _ in range(dice.choice((0, 1, 1, 2))):
        draw_loads.load(draft)
    rubs = draft.chance(0.08) and draw_rare.rubbing(draft)
    if not rubs:
        draw_rare.rarely(draft)
    draw_loads.start(draft, [name for name in draft.coordinates if name not in draft.tied], rubs)
    if any("law" in spring for spring in draft.springs.values()):
        draft.sections["motion"] = "full"
    if "motion" not in draft.sections and draft.chance(0.05):
        draft.sections["motion"] = "small"
    return draft
