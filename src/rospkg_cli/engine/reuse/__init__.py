"""What is kept of each package between runs, and which of it still holds: its facts, and the findings of its rules."""
