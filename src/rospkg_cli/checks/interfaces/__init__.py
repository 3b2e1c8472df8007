"""Judgements over messages, services and actions."""
