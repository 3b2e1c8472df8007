"""What lint found before, kept in the user's cache with all that it saw, and served only where it would see the same.

Plain text that is read back without running anything, in a folder that is the user's own. Whatever is wrong with a
file of it, the file counts as absent; where there is no place for it, nothing is kept and nothing is said.
"""
