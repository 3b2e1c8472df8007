"""Requests are answered soon or not at all: an editor asks again, and does not wait for it."""

from __future__ import annotations

import asyncio
import logging
from collections.abc import Awaitable
from typing import TypeVar

from pygls.exceptions import JsonRpcContentModified

from .refusal import NOT_YET

T = TypeVar("T")


async def in_time(answer: Awaitable[T], limit: float) -> T:
    """Return an answer; raises JsonRpcContentModified where it takes longer."""
    try:
        return await asyncio.wait_for(answer, limit)
    except asyncio.TimeoutError:
        raise JsonRpcContentModified(NOT_YET) from None


def is_worth_a_line(record: logging.LogRecord) -> bool:
    """Return whether pygls is to log something: it takes each error for a fault, this one too."""
    error = record.exc_info[1] if record.exc_info else None
    return not isinstance(error, JsonRpcContentModified)


def quieten() -> None:
    logging.getLogger("pygls.protocol.json_rpc").addFilter(is_worth_a_line)
