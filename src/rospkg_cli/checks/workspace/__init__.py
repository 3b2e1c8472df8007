"""Judgements over several packages together."""
