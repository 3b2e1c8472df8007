"""Judgements over robot descriptions."""
