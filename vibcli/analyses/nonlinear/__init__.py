"""Free motions of nonlinear scenes: periods, and how they depend on the amplitude."""
