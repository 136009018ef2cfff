"""Kinematics: every body, spring and damper as scalar functions s(q, t) with their weights."""
