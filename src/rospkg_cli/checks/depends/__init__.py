"""Judgements over dependencies: what is needed, declared, unknown, unused."""
