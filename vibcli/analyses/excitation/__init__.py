"""What drives a linear system: its forcing, piece by piece in time, and what is read off it."""
