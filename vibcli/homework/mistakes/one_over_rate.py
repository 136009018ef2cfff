"""The reciprocal of an angular frequency for the period, 1/ω for 2π/ω."""

from math import tau

from vibcli.homework.mistakes.mistake import PERIODS, CommonMistake, by_reading

MISTAKE = CommonMistake("this is 1/ω: the period is 2π/ω", reading=by_reading(1 / tau, PERIODS))
