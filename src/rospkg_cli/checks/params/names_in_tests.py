"""Parameters that the tests of a node's own package call as a file or a launch file does, and its code otherwise."""

from __future__ import annotations

import re

from ...files import PackageFiles
from ...package.file_role import role_of
from ...package.package_facts import PackageFacts
from ..repository.left_to_people import files_of

CODE = (".py", ".cpp", ".cc", ".cxx", ".hpp", ".h", ".yaml", ".yml")


def is_in_tests(files: PackageFiles, owner: PackageFacts | None, name: str, intended: str, place: str) -> bool:
    """Return whether tests of a package have a name, and not the one that its code declares: that may be the slip.

    The file at whose place this is asked says nothing of itself.
    """
    own = files_of(files, owner, own=owner.folder == files.folder) if owner is not None and intended else None
    if own is None:
        return False
    word, other = (
        re.compile(rf"[\"']{re.escape(each)}[\"']|(?m:^[ \t]*{re.escape(each)}[ \t]*:)") for each in (name, intended)
    )
    tests = [path for path in own.paths if path.endswith(CODE) and role_of(path) == "test"]
    texts = [own.readable_text(path) for path in tests if own is not files or path != place]
    return any(map(word.search, texts)) and not any(map(other.search, texts))
