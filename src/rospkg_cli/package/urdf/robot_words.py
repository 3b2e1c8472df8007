"""The words by which the launch files, the code and the robots of a package may name robots of others."""

from __future__ import annotations

from ...files import ReaderInput
from ...lazy_regex import regex
from ..file_role import role_of
from ..launch.text import uncommented

NAMING = (
    ".py",
    ".xml",
    ".launch",
    ".yaml",
    ".yml",
    ".cpp",
    ".cc",
    ".hpp",
    ".h",
    ".urdf",
    ".xacro",
    ".sdf",
    ".world",
    ".md",
)
MARKS = (b"urdf", b"xacro", b".sdf", b"find ")
"""One of them stands in each text that names a robot."""
ANY = "*"
"""Stands for a name that is put together when the text is run."""
WORD = regex(r"(?:[\"'/:,=\[-] ?|find(?:-pkg-share)? )([A-Za-z][\w-]*)")
INCLUDE = regex(r"<xacro:include\s[^>]*?filename\s*=\s*[\"']\$\(find\s+([\w-]+)\s*\)/([^\"']*)")
FILE = regex(r"(?:^|[^\w.-])([\w.-]*)\.(?:urdf|xacro|sdf)\b")


def robot_words(reading: ReaderInput) -> tuple[frozenset[str], ...]:
    """Return the words in quotes and paths of each text that tells of robots, and `*` where a name is put together."""
    files = reading.files
    paths = (path for path in files.paths if path.endswith(NAMING) and role_of(path) not in ("test", "aside"))
    telling = (path for path in paths if path != "package.xml" and any(files.holds(path, mark) for mark in MARKS))
    return tuple(words_of(uncommented(path, files.readable_text(path))) for path in telling)


def robot_includes(reading: ReaderInput) -> frozenset[tuple[str, str]]:
    """Return the files of other packages that the robots of a package include: package and path."""
    files = reading.files
    paths = (
        path for path in files.paths if path.endswith((".xacro", ".urdf")) and role_of(path) not in ("test", "aside")
    )
    texts = (files.readable_text(path) for path in paths if files.holds(path, b"xacro:include"))
    return frozenset((match.group(1), match.group(2)) for text in texts for match in INCLUDE.finditer(text))


def words_of(text: str) -> frozenset[str]:
    is_put_together = any(name[:1] in ("", ".", "_", "-") for name in FILE.findall(text))
    return frozenset(WORD.findall(text)) | ({ANY} if is_put_together else set())
