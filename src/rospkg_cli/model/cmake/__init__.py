"""CMake as CMake reads it: tokens, commands, blocks, and a bounded static evaluation of them.

The lexer is our own because tree-sitter's grammar counts bytes, hides the rest of a file behind one unclosed `(`,
accepts what CMake refuses (two commands in a line), and would be one more compiled dependency.
"""
