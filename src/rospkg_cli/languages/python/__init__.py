"""Python: syntax trees with places in characters, and an evaluator that runs nothing."""
