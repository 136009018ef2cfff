"""Where things stand on the paper."""
