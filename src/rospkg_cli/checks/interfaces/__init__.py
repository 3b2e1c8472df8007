"""Checks of messages, services and actions."""
