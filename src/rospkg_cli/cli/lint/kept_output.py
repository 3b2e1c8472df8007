"""What a run prints, kept for the cache, and which runs may be kept at all."""

from __future__ import annotations

import io
from typing import IO

from .lint_options import FixOptions, LintOptions


class KeptOutput(io.StringIO):
    """Standard output that remembers what was written to it."""

    def __init__(self, stream: IO[str]) -> None:
        super().__init__()
        self.stream = stream

    def write(self, text: str) -> int:
        super().write(text)
        return self.stream.write(text)

    def isatty(self) -> bool:
        return self.stream.isatty()

    def text(self) -> str:
        return self.getvalue()


def may_be_kept(options: LintOptions) -> bool:
    """Return whether a run does nothing but print findings of files: what asks git or standard input never is."""
    is_unknown = options.changed or options.since is not None or options.stdin_filename is not None
    return not (is_unknown or writes(options) or options.no_cache or options.show_settings or options.report.output)


def writes(options: LintOptions) -> bool:
    """Return whether a run changes files of a package, or writes a baseline."""
    suppression = options.suppression
    wanted = suppression.add_ignores is not None or suppression.write_baseline is not None
    return wanted or options.fixing != FixOptions()
