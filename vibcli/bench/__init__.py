"""`python -m vibcli.bench`: run time, memory, growth and accuracy against named baselines and fixed budgets."""
