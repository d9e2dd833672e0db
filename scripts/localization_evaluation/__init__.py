"""What scripts/evaluate_localization is made of: sequences, runs of replay on them, and the table."""
