"""What scripts/compare_with is made of."""
