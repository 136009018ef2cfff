"""The opposite direction."""

from vibcli.homework.mistakes.mistake import CommonMistake

MISTAKE = CommonMistake("the sign differs: which direction is positive?", reading=lambda value, head, unit: -value)
