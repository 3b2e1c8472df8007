"""Repairs that people made in public repositories: does lint name the fault before them, and not after?"""
