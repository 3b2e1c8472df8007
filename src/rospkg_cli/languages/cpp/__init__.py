"""C++ as far as a package's other files refer to it: what it includes, and the few calls that register something.

This is no parser of C++. Comments, strings and preprocessor lines are told apart from code, and a call is followed
to its closing parenthesis; types, overloads and macros of the package's own are not understood.
"""
