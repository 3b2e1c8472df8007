"""A bounded, static evaluator of Python: what a file would compute, as far as its own text and its package tell.

Nothing is executed and nothing outside of the package is looked at.  What can't be known is an `Unknown`; a call of
a function that the evaluator doesn't know is a `Call`, which whoever uses the evaluator may interpret.
"""
