"""YAML with exact places."""
