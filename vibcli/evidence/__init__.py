"""Run time against true error: what a scene asks, answered by every method that can, beside values to many digits."""
