"""A bounded, static evaluator of Python: the values that a file computes from its own text and its package.

Nothing is executed and nothing outside of the package is read.  An unknown value is an `Unknown`; a call of a
function that the evaluator doesn't know is a `Call`, which the caller may interpret.
"""
