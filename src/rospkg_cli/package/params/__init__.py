"""Parameters: what files give, and what code declares."""
