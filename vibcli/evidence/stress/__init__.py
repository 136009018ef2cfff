"""Families of scenes with one knob, each point beside its true value and beside a plain method."""
