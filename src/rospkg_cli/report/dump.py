"""JSON that every reader takes, on any stream."""

from __future__ import annotations

import codecs
import json
from typing import IO, Any

from ..control_characters import in_json, without_surrogates


def dump(document: Any, stream: IO[str]) -> None:
    """Write a document with two blanks a level.

    What a terminal or a log would obey is escaped as JSON escapes it. Bytes of a file name that are no text are shown
    (`\\\\udcff`): half a surrogate pair is refused by many readers. Where the stream is not UTF-8, all is ASCII.
    """
    text = without_surrogates(json.dumps(document, indent=2, ensure_ascii=False))
    stream.write(in_json(text, not is_unicode(stream)) + "\n")


def is_unicode(stream: IO[str]) -> bool:
    """Return whether a stream takes every character; one in memory does."""
    encoding = getattr(stream, "encoding", None)
    return encoding is None or codecs.lookup(encoding).name.startswith("utf-")
