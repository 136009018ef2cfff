"""Natural frequencies, mode shapes and damping in letters."""
