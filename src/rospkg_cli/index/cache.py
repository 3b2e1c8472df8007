"""The index as it lies in the user's cache: one file, replaced in one step."""

from __future__ import annotations

import time
from collections.abc import Mapping
from contextlib import suppress
from pathlib import Path

from ..disk_trace import read
from ..ros.name_index import BrokenIndexError, Index, check, dump, parse
from ..ros.names import BUILT_IN, FetchedNames, Names
from . import NamesError

STRAY_SECONDS = 600
"""A temporary file of that age was left over: writing an index takes less than one second."""


def cache_file(environment: Mapping[str, str]) -> Path:
    """Return where the index lies: in $XDG_CACHE_HOME, else in ~/.cache; raises NamesError where there is no home."""
    folder = Path(environment.get("XDG_CACHE_HOME", ""))
    if not folder.is_absolute():  # the specification wants such a value passed over
        home = environment.get("HOME") or environment.get("USERPROFILE")
        if not home:
            raise NamesError("there is no place for the index: neither XDG_CACHE_HOME nor HOME is set")
        folder = Path(home, ".cache")
    return folder / "rospkg" / "index.txt"


def read_text(environment: Mapping[str, str]) -> str | None:
    """Return the text of the index, None where there is none; raises NamesError where it is of no use."""
    try:
        path = cache_file(environment)
    except NamesError:
        return None
    try:
        text = read(path).decode("utf-8")
        check(text)
    except (FileNotFoundError, NotADirectoryError):
        return None
    except OSError as error:
        raise NamesError(f"the index `{path}` can't be read: {error.strerror or error}") from None
    except (UnicodeError, BrokenIndexError) as error:
        why = str(error) if isinstance(error, BrokenIndexError) else "it is broken"
        raise NamesError(f"the index `{path}` is of no use: {why}; `rospkg index update` makes it anew") from None
    return text


def names(environment: Mapping[str, str]) -> Names:
    """Return the names that were fetched, else those that are built in; raises NamesError.

    Nothing is looked into before the first name is asked for.
    """
    text = read_text(environment)
    return BUILT_IN if text is None else FetchedNames(text)


def cached_index(environment: Mapping[str, str]) -> Index | None:
    """Return the index that was fetched, None where there is none; raises NamesError."""
    text = read_text(environment)
    return None if text is None else parse(text)


def cache_index(index: Index, environment: Mapping[str, str]) -> Path:
    """Put an index in the place of the one before; return its file. Raises NamesError, and the old one stays."""
    from ..engine.fixing.write import WriteError, write_text

    path = cache_file(environment)
    try:
        remove_leftovers(path)
        write_text(path, dump(index))
    except WriteError as error:
        raise NamesError(f"{error}; what was there is left as it was") from None
    return path


def remove_leftovers(path: Path) -> None:
    """Remove what runs that were killed while they wrote have left next to the index."""
    for stray in path.parent.glob(f".{path.name}.*"):
        with suppress(OSError):
            if time.time() - stray.lstat().st_mtime > STRAY_SECONDS:
                stray.unlink()
