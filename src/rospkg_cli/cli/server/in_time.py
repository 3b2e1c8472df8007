"""Requests are answered soon or not at all: an editor asks again, and nobody waits for it."""

from __future__ import annotations

import asyncio
import logging
from collections.abc import Awaitable
from typing import TypeVar

from lsprotocol import types
from pygls.exceptions import JsonRpcContentModified

T = TypeVar("T")

LIMIT = 0.12
"""Seconds for an answer: those of the messages to and fro come on top."""

OPTION = "answerWithin"
"""What an editor may say among its `initializationOptions`: other seconds."""

NOT_YET = "rospkg is still reading what has changed: ask again"


async def in_time(answer: Awaitable[T], limit: float) -> T:
    """Return an answer; raises JsonRpcContentModified where it takes longer.

    Of the errors of the protocol that is the one which editors do not show (Neovim, VS Code): ServerCancelled is for
    requests of other kinds, and RequestCancelled for what the editor itself has cancelled.
    """
    try:
        return await asyncio.wait_for(answer, limit)
    except asyncio.TimeoutError:
        raise JsonRpcContentModified(NOT_YET) from None


def limit_of(asked: types.InitializeParams) -> float:
    """Return the seconds that an editor gives for an answer."""
    options = asked.initialization_options
    given = options.get(OPTION) if isinstance(options, dict) else getattr(options, OPTION, None)
    return float(given) if isinstance(given, (int, float)) and given > 0 else LIMIT


def is_worth_a_line(record: logging.LogRecord) -> bool:
    """Return whether pygls is to log something: it takes each error for a fault, this one too."""
    error = record.exc_info[1] if record.exc_info else None
    return not isinstance(error, JsonRpcContentModified)


def quieten() -> None:
    logging.getLogger("pygls.protocol.json_rpc").addFilter(is_worth_a_line)
