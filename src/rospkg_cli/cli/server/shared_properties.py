"""Cached properties that several threads compute at once, as they have been since Python 3.12."""

from __future__ import annotations

import sys
from functools import cached_property
from typing import Any


def let_threads_compute() -> None:
    """Take away the lock that all instances of a class share before Python 3.12, and under which one is computed.

    A run that reads thousands of files inside of a property would have what an editor asks wait for it.
    """
    if sys.version_info < (3, 12):
        setattr(cached_property, "__get__", get)  # noqa: B010  # mypy takes a method for something that stays


def get(self: Any, instance: Any, owner: type | None = None) -> Any:
    """Return the value of a property, and remember it; one that two threads compute at once is computed twice."""
    if instance is None:
        return self
    known = instance.__dict__
    if self.attrname not in known:
        known[self.attrname] = self.func(instance)
    return known[self.attrname]
