"""Judgements over setup.py and setup.cfg."""
