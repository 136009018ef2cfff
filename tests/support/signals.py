"""Signals as they are written, of a Problem."""

from vibcli.api.given import expression
from vibcli.report.sections.requested_signals import require_known


def signal_of(found, text):
    """The signal of a motion in time that a text asks for."""
    asked = expression(text, "the signal")
    require_known(found.spec, [asked])
    return found.response.signal(asked.tree)
