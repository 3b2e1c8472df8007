"""What an editor gets instead of an answer that takes too long."""

from __future__ import annotations

import json
from collections.abc import Mapping
from typing import Any

LIMIT = 0.12
"""Seconds for an answer: those of the messages to and fro come on top."""

MOST = 3600.0
"""The most seconds that an editor waits for an answer."""

OPTION = "answerWithin"
"""What an editor may say among its `initializationOptions`: other seconds."""

NOT_YET = "rospkg is still reading what has changed: ask again"

CONTENT_MODIFIED = -32801
"""Of the errors of the protocol that is the one which editors do not show (Neovim, VS Code): ServerCancelled is for
requests of other kinds, and RequestCancelled for what the editor itself has cancelled."""

RESOLVE = "codeAction/resolve"

UNANSWERED = "rospkg/unanswered"
"""The message to the server that an action was resolved without the edit, which may be ready by now."""

REFUSED = frozenset(
    {
        RESOLVE,
        "textDocument/codeAction",
        "textDocument/completion",
        "textDocument/definition",
        "textDocument/formatting",
        "textDocument/hover",
    }
)
"""What is asked again where it is refused; other requests are about the server itself."""


def limit_in(options: object) -> float:
    """Return the seconds that an editor gives for an answer in its `initializationOptions`."""
    given = options.get(OPTION) if isinstance(options, dict) else getattr(options, OPTION, None)
    return min(float(given), MOST) if isinstance(given, (int, float)) and given > 0 else LIMIT


def refusal(asked: Mapping[str, Any]) -> bytes:
    """Return the body that stands for the answer to a request.

    An action is resolved without its edit: the command that it has makes that later.
    """
    if asked["method"] == RESOLVE:
        given: dict[str, object] = {"result": asked.get("params")}
    else:
        given = {"error": {"code": CONTENT_MODIFIED, "message": NOT_YET}}
    return json.dumps({"jsonrpc": "2.0", "id": asked["id"], **given}).encode()


def unanswered(asked: Mapping[str, Any]) -> bytes:
    """Return the message to the server on an action whose edit the editor did not get; b"" for other requests."""
    data = (asked.get("params") or {}).get("data") if asked["method"] == RESOLVE else None
    if not isinstance(data, dict):
        return b""
    return json.dumps({"jsonrpc": "2.0", "method": UNANSWERED, "params": {"key": data.get("key")}}).encode()
