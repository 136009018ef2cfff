"""Response in time of a linear system, M q̈ + C q̇ + K q = f(t), in closed form at any time."""
