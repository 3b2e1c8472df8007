"""The two processes of the server: the one that an editor has started, and the one that knows the packages."""

from __future__ import annotations

import os
from collections.abc import Callable
from contextlib import suppress

from .front import Front, Streams


def behind_front(serve: Callable[[], int]) -> int:
    """Serve in a process of its own, and return its exit status; in this one where there is no fork (Windows).

    The child has the streams of a server; where the parent is killed, its input ends.
    """
    if not hasattr(os, "fork"):
        return serve()
    (asked, to_server), (from_server, said) = os.pipe(), os.pipe()
    server = os.fork()
    if not server:
        os.dup2(asked, 0)
        os.dup2(said, 1)
        for each in (asked, to_server, from_server, said):
            os.close(each)
        return serve()
    os.close(asked)
    os.close(said)
    editor = Streams(os.fdopen(os.dup(0), "rb"), os.fdopen(os.dup(1), "wb"))
    with suppress(KeyboardInterrupt):
        Front(editor, Streams(os.fdopen(from_server, "rb"), os.fdopen(to_server, "wb"))).run()
    status = os.waitstatus_to_exitcode(os.waitpid(server, 0)[1])
    return status if status >= 0 else 128 - status
