"""One run of lint: which packages, which rules, what is set aside, and what is fixed."""
