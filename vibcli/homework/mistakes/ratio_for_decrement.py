"""The decrement of weak damping, 2πζ."""

from vibcli.homework.mistakes.mistake import CommonMistake, by_formula

MISTAKE = CommonMistake("2πζ holds for weak damping alone: the decrement is 2πζ/√(1 − ζ²)",
                  formula=by_formula("2*pi*zeta[1]", ("decrement",)))
