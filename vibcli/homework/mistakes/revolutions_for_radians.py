"""Revolutions per minute for radians per second."""

from math import tau

from vibcli.homework.mistakes.mistake import RATES, CommonMistake, by_reading

MISTAKE = CommonMistake("this is in revolutions per minute",
                  reading=by_reading(60 / tau, RATES))
