"""RPK007 skipped-file."""

from __future__ import annotations

from collections.abc import Iterator

from ...checks.read_sentences import what_is_wrong
from ...finding import Hit, Severity
from ...rule import rule
from ...unreadable import Unreadable


@rule(
    "RPK007",
    "skipped-file",
    over=Unreadable,
    severity=Severity.INFO,
    examples=(),
)
def skipped_file(file: Unreadable) -> Iterator[Hit]:
    """
    ## What it does
    Reports a file that exists and is not read.
    It is larger than 4 MB or nested too deeply, or a link to a file that is neither in the package nor in its git
    repository, a pointer of Git LFS that `git lfs pull` was not run for, or encrypted by git-crypt. Rules that need the
    file are skipped.

    ## Why is this bad?
    What is not read is not checked. A link that leads out is never followed, so that a repository can't make its
    linter print or rewrite a file of the machine that lints it.

    ## When it is quiet
    Files that no reader asks for may be of any size.
    """
    if file.skipped:
        yield Hit(file.path, file.span, what_is_wrong(file))
