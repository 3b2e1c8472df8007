"""A stand-in for rclpy, because the real one can't be had from a package index.

It behaves as rclpy does, by its sources, where a node can get it wrong: `init` returns None (up to Jazzy it is no
context manager), SIGINT raises KeyboardInterrupt and shuts the context down, SIGTERM shuts it down so that `spin`
raises ExternalShutdownException, a second `shutdown` is an error, `try_shutdown` is none.  `spin` plays the rest of
the graph too: it publishes to subscriptions, calls services, answers clients, sends goals, drives a lifecycle.
What the node did is appended to the file that STANDIN_LOG names, one JSON object a line.
"""

from __future__ import annotations

import json
import os
import signal
import threading
from pathlib import Path
from time import sleep
from types import FrameType
from typing import Any

_state: dict[str, Any] = {"ok": False, "initialized": False}
_writing = threading.Lock()


def note(what: str, **values: object) -> None:
    with _writing, Path(os.environ["STANDIN_LOG"]).open("a", encoding="utf-8") as log:
        log.write(json.dumps({"what": what, **values}) + "\n")


def init(*, args: list[str] | None = None) -> None:
    if _state["initialized"]:
        raise RuntimeError("Context.init() must only be called once")
    _state.update(ok=True, initialized=True)
    signal.signal(signal.SIGINT, _interrupt)
    signal.signal(signal.SIGTERM, _terminate)
    note("init", args=args)


def _interrupt(number: int, frame: FrameType | None) -> None:
    _state["ok"] = False
    raise KeyboardInterrupt


def _terminate(number: int, frame: FrameType | None) -> None:
    _state["ok"] = False


def ok() -> bool:
    return bool(_state["ok"])


def shutdown() -> None:
    if not _state["ok"]:
        raise RuntimeError("failed to shutdown: rcl_shutdown already called on the given context")
    try_shutdown()


def try_shutdown() -> None:
    _state["ok"] = False
    note("shutdown")


def spin(node: Any, executor: Any = None) -> None:
    from rclpy.executors import ExternalShutdownException

    note("spin", node=node.name, executor=type(executor).__name__)
    while ok():
        for turn in list(node.turns):
            if turn in node.turns:  # another turn may have taken it away
                turn()
        sleep(0.01)
    raise ExternalShutdownException
