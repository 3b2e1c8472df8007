"""Judgements over parameter files."""
