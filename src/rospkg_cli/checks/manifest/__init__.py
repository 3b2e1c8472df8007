"""Judgements over package.xml."""
