"""Bars, shafts, strings and beams exactly: natural frequencies, shapes, responses, travelling waves."""
