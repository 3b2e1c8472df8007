"""Judgements over launch files."""
