"""Judgements over CMakeLists.txt."""
