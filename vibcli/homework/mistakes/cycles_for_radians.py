"""Cycles for radians: f = ω/2π."""

from math import tau

from vibcli.homework.mistakes.mistake import RATES, CommonMistake, by_reading

MISTAKE = CommonMistake("this is the frequency in Hz: ω = 2πf",
                  reading=by_reading(1 / tau, RATES))
