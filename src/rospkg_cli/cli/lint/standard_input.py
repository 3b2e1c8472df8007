"""`rospkg lint - --stdin-filename FILE`: a text that an editor has not saved, in its package."""

from __future__ import annotations

import sys
from pathlib import Path

from ...current_folder import absolute
from ...disk_trace import MAX_BYTES
from ...engine.fixing.overlay import Overlay
from ...engine.run.results import Results
from ...engine.run.session import Session
from ...light_dataclasses import replace
from ...tree import TreeEntry
from .. import UsageError


def with_standard_input(session: Session, root: Path, file: Path) -> Session:
    """Return a run in which standard input lies over a file, and which reports on that file alone.

    Raises UsageError where there is more than is read of a file.
    """
    data = sys.stdin.buffer.read(MAX_BYTES + 1)
    if len(data) > MAX_BYTES:
        raise UsageError(f"standard input has more than the limit of {MAX_BYTES // 1_000_000} MB")
    path = absolute(file).relative_to(root).as_posix()
    try:
        entry = replace(session.tree.entry(path), data=data, skipped="")
    except OSError:
        entry = TreeEntry("file", data)
    filter_results = session.filter_results

    def of_file(run: Session, results: Results) -> Results:
        found = filter_results(run, results)
        findings = (each for each in found.findings if each.location.path == path)
        return replace(found, findings=tuple(findings), packages=1, files=1)

    return replace(session, tree=Overlay(session.tree, {path: entry}), filter_results=of_file, kept=None)
