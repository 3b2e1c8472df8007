"""The index of names: fetched from rosdistro, kept in the user's cache, and read when a name is looked up."""

from ..sentence import single_line
from ..user_error import UserError


class NamesError(UserError):
    """An index that can't be fetched, kept or read; the message is one sentence that says what to do."""

    def __str__(self) -> str:
        """The sentence on one line, whatever of a stranger's file it quotes."""
        return single_line(super().__str__())
