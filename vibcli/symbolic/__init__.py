"""The expression: syntax, table, derivatives, evaluation, normal forms."""
