"""Homework: the variants of a problem, solved and passed through gates before they are handed out."""

RIGHT, WRONG, UNREADABLE, MISSING = "right", "wrong", "unreadable", "missing"       # verdicts on answers
SET = "set.yaml"        # the name of a file that names problems
