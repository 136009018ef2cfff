"""The ground floor: errors, units, diagnostics, files written whole, bounded work."""
