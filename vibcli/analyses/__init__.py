"""What is computed from the equations of motion."""
