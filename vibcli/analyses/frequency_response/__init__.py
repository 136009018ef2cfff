"""Frequency response: what harmonic inputs do in the steady state."""
