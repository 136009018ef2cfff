"""Nonlinear motion in time: the full equations integrated by collocation, window by window."""
