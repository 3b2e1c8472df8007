"""Give files and folders new names on disk: all of them, or none, with everything that lies in them."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from contextlib import suppress
from pathlib import Path

from .signals import signals_ignored, stopped_by_signals
from .write import WriteError


def move_all(root: Path, renamed: Mapping[str, str], then: Callable[[], None]) -> None:
    """Rename paths below a folder, as `MovedTree` has them, then do what else belongs to it.

    Raises WriteError where a name can't be given: then all old names are back, as they are where `then` raises.
    """
    done: list[tuple[Path, Path]] = []
    with stopped_by_signals():
        try:
            for path, name in sorted(renamed.items(), key=lambda each: -each[0].count("/")):
                old, new = root / path, (root / path).with_name(name)
                if new.exists() or new.is_symlink():
                    raise WriteError(f"`{new}` exists; nothing was renamed")
                old.rename(new)
                done.append((old, new))
            then()
        except BaseException as error:
            with signals_ignored():
                for old, new in reversed(done):
                    with suppress(OSError):
                        new.rename(old)
            if isinstance(error, OSError):
                raise WriteError(
                    f"`{path}` can't be renamed: {error.strerror or error}; nothing was renamed"
                ) from error
            raise
