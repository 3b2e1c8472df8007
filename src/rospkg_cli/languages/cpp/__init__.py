"""C++ as far as a package's other files refer to it: what it includes, and the few calls that register something.

This is not a parser of C++. Comments, strings and preprocessor lines are separated from code, and a call is read to
its closing parenthesis; types, overloads and macros of the package are not understood.
"""
