"""The text of one file of a tree, or the reason why it has none."""

from __future__ import annotations

from .read_problem import ReadProblem
from .source import Source, Span
from .tree import LeadsOutError, SkippedError, Tree
from .unreadable import UnreadableError

STAND_INS = {
    b"version https://git-lfs.github.com/spec/": ReadProblem.LFS_POINTER,
    b"\0GITCRYPT\0": ReadProblem.GIT_CRYPT,
}
"""How a file begins that git has in place of the real one, which people must fetch or unlock."""


def read_text(tree: Tree, path: str) -> Source:
    """Return the text of a file; raises UnreadableError where it has none."""
    try:
        entry = tree.entry(path)
        refuse_stand_in(path, entry.data)
        return Source(path, entry.text.text)
    except UnicodeError as error:
        raise undecodable(path, error) from None
    except SkippedError as error:
        outside = isinstance(error, LeadsOutError)
        raise UnreadableError(
            path, Span(0, 0), ReadProblem.SKIPPED, str(error), skipped=True, outside=outside
        ) from None
    except OSError as error:
        why = str(error.strerror or error)
        raise UnreadableError(path, Span(0, 0), ReadProblem.NO_ACCESS, why) from None


def refuse_stand_in(path: str, data: bytes) -> None:
    for start, problem in STAND_INS.items():
        if data.startswith(start):
            raise UnreadableError(path, Span(0, 0), problem, skipped=True)


def undecodable(path: str, error: UnicodeError) -> UnreadableError:
    if isinstance(error, UnicodeDecodeError):
        return UnreadableError(path, Span(0, 0), ReadProblem.ENCODING, error.encoding, str(error.start))
    return UnreadableError(path, Span(0, 0), ReadProblem.UNDECODABLE, str(error))
