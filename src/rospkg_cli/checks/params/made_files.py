"""Files that a parameter names and that need not be there before a node runs: it writes them, or people bring them."""

from __future__ import annotations

import posixpath
from collections.abc import Iterable

from ...lazy_regex import regex

WRITES = regex(
    r"(?i)(?:^|[._])(?:out|output|save|saving|log|logging|record|recording|write|written|export|results?|dump)(?:[._]|$)"
)
"""Words of a parameter whose value is where a node writes."""
HEAVY = frozenset({
    ".bag", ".bin", ".caffemodel", ".ckpt", ".db3", ".engine", ".h5", ".mcap", ".onnx", ".pb", ".pcd", ".plan", ".pt",
    ".pth", ".rknn", ".safetensors", ".tflite", ".trt", ".weights",
})  # fmt: skip
"""Endings of trained models and recordings, which are made, or fetched as they are too large for git."""
ARCHIVES = regex(r"\.(?:zip|tar|tar\.\w+|tgz|gz|bz2|xz|7z|rar)$")
WRITTEN = "until the node writes it"
FETCHED = "until it is made or fetched, as such a file mostly is"
PACKED = "until `{}` is unpacked"


def why_written(key: str) -> str:
    """Return that a node writes the file which a parameter of a name holds; "" where nothing says so."""
    return WRITTEN if WRITES.search(key) else ""


def why_made(path: str, others: Iterable[str]) -> str:
    """Return why a file need not be there; "" where it has to be.

    One of the same kind that is there shows that a repository has such files itself.
    """
    stem, end = posixpath.splitext(path)
    neighbours = list(others)
    if end.lower() in HEAVY and not any(each.lower().endswith(end.lower()) for each in neighbours):
        return FETCHED
    packed = next((each for each in neighbours if ARCHIVES.sub("", each) in (stem, path) and ARCHIVES.search(each)), "")
    return PACKED.format(packed) if packed else ""
