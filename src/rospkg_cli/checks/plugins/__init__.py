"""Judgements over plugins."""
