"""The opposite direction, of what has one."""

from vibcli.mistakes.mistake import UNSIGNED, CommonMistake


def _wrong(value, head, unit):
    return -value if head not in UNSIGNED else None


MISTAKE = CommonMistake("the sign differs: which direction is positive?", reading=_wrong)
