"""`--add-ignores REASON`: an ignore comment above each finding, where the file can hold one."""

from __future__ import annotations

from collections import defaultdict
from collections.abc import Iterable, Iterator
from pathlib import PurePosixPath

from ...finding import Edit, Finding, Fix
from ...source import Source, Span
from ...tree import Tree

XML = frozenset({".xml", ".launch", ".urdf", ".xacro", ".sdf", ".world"})
HASH = frozenset({".py", ".cfg", ".txt", ".cmake", ".yaml", ".yml", ".msg", ".srv", ".action"})
SLASHES = frozenset({".c", ".cc", ".cpp", ".cxx", ".h", ".hh", ".hpp", ".hxx"})


def ignore_comments(tree: Tree, findings: Iterable[Finding], reason: str) -> Iterator[Fix]:
    """Yield the insertion of one comment for each line that has findings; none where a file takes no comments."""
    lines: dict[tuple[str, int], set[str]] = defaultdict(set)
    for finding in findings:
        if PurePosixPath(finding.location.path).suffix in XML | HASH | SLASHES and not finding.code.startswith("RPK"):
            lines[finding.location.path, finding.location.line].add(finding.code)
    for (path, line), codes in sorted(lines.items()):
        source = Source(path, tree.entry(path).text.text)
        at = source.line_span(line)
        excerpt = source.slice(at)
        indent = excerpt[: len(excerpt) - len(excerpt.lstrip())]
        comment = comment_text(path, f"rospkg: ignore[{', '.join(sorted(codes))}]", reason)
        if line == 1 and excerpt.startswith(("<?xml", "#!")):
            continue
        yield Fix(f"Ignore {', '.join(sorted(codes))}", (Edit(path, Span(at.start, at.start), f"{indent}{comment}\n"),))


def comment_text(path: str, words: str, reason: str) -> str:
    """Return the comment in the language of the file; XML does not allow `--` in a comment."""
    reason = " ".join(reason.split())
    if PurePosixPath(path).suffix in XML:
        return f"<!-- {words} {reason.replace('--', '–')} -->"
    return f"{'//' if PurePosixPath(path).suffix in SLASHES else '#'} {words} {reason}"
