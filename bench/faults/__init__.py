"""A mutation bench: single faults of many kinds put into real packages, and whether lint sees them."""
