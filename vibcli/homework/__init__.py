"""Homework: the variants of a problem, solved and passed through gates before they are handed out."""

SET = "set.yaml"        # the name of a file that names problems
