"""Writing packages: from what was asked for to files that are right."""

from ..sentence import single_line


class ScaffoldError(Exception):
    """What can't be written as asked; the message is one sentence that says why and what to do."""

    def __str__(self) -> str:
        """The sentence on one line, whatever it quotes."""
        return single_line(super().__str__())


class OwnFaultError(Exception):
    """A template that writes what our own linter refuses."""
