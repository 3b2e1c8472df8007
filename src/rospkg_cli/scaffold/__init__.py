"""Writing packages: from what was asked for to files that are right."""


class ScaffoldError(Exception):
    """What can't be written as asked; the message is one sentence that says why and what to do."""


class OwnFaultError(Exception):
    """A template that writes what our own linter refuses."""
