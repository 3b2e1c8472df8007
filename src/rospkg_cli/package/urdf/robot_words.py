"""The words by which the launch files, the code and the robots of a package may name robots of others."""

from __future__ import annotations

from ...files import ReaderInput
from ...lazy_regex import regex
from ..file_role import is_set_aside, role_of
from ..launch.live_text import live_text

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
MARKS = (b"urdf", b"xacro", b".sdf", b".world", b"find ")
"""Each text that names a robot has one of these."""
ANY = "*"
"""Added where a name is composed at run time."""
LAUNCH = ">"
"""Added to the words of a launch file."""
REPLACES = "~"
"""Added to the words of a text that replaces paths of a robot, as `.replace('package://…', …)` does."""
REPLACED = regex(r"(?:\.replace|\bsub)\(\s*[rf]{0,2}[\"'][^\"'\n]*(?:://|meshes)")
WORD = regex(r"(?:[\"'/:,=\[-] ?|find(?:-pkg-share)? )([A-Za-z][\w-]*)")
GIVEN = regex(
    r"[\"'](\w{1,64})[\"']\s*[,:]\s*(?:default(?:_value)?\s*=\s*)?[\"']([^\"'\n]*)[\"']"
    r"|(?<!\w)(\w{1,64}):=[\"']?([\w.-]+)|\bname=\"(\w{1,64})\"\s+(?:default|value)=\"([^\"\n]*)\""
)
"""How Python, a command and XML give an argument a literal value, or declare one of its name with it."""
KEYWORD = regex(r"(?<![\w.])([a-z]\w{0,63})=(?!=)")
INCLUDE = regex(r"<xacro:include\s[^>]*?filename\s*=\s*[\"']\$\(find\s+([\w-]+)\s*\)/([^\"']*)")
FILE = regex(r"(?:^|[^\w.-])([\w.-]*)(\.(?:urdf|xacro|sdf|world))\b")


def robot_words(reading: ReaderInput) -> tuple[frozenset[str], ...]:
    """Return the words in quotes and paths, and the file names, of each text about robots.

    `*` is among them where a name is put together, `>` where the text is a launch file that is not laid aside, and
    `sim:=false` where it gives an argument a literal value, `sim=` where it has one of that name in a call.
    """
    files = reading.files
    paths = (path for path in files.paths if path.endswith(NAMING) and role_of(path) not in ("test", "aside"))
    telling = (path for path in paths if path != "package.xml" and any(files.holds(path, mark) for mark in MARKS))
    texts = ((path, live_text(files, path)) for path in telling)
    return tuple(
        words_of(text) | given_in(text) | ({LAUNCH} if is_launch(path) else frozenset()) for path, text in texts
    )


def given_in(text: str) -> frozenset[str]:
    """Return the arguments that a text gives literal values, as a command does: `sim:=false`; and keywords: `sim=`."""
    pairs = (list(filter(None, each)) for each in GIVEN.findall(text))
    literal = (f"{pair[0]}:={pair[1]}" for pair in pairs if len(pair) > 1)
    return frozenset((*literal, *(f"{each}=" for each in KEYWORD.findall(text))))


def is_launch(path: str) -> bool:
    return role_of(path) == "launch" and not is_set_aside(path)


def robot_includes(reading: ReaderInput) -> frozenset[tuple[str, str, str]]:
    """Return the files of packages that the robots of a package include: package, path, and the file that does it."""
    files = reading.files
    paths = (
        path for path in files.paths if path.endswith((".xacro", ".urdf")) and role_of(path) not in ("test", "aside")
    )
    texts = ((path, files.readable_text(path)) for path in paths if files.holds(path, b"xacro:include"))
    return frozenset((found.group(1), found.group(2), path) for path, text in texts for found in INCLUDE.finditer(text))


def may_be_made(name: str, words: frozenset[str]) -> bool:
    """Return whether a text with these words may put a file name together: it has its end, as `.urdf.xacro`."""
    return ANY in words and any(name.endswith(word) for word in words if word[0] in "._-")


def words_of(text: str) -> frozenset[str]:
    names = FILE.findall(text)
    is_put_together = any(name[:1] in ("", ".", "_", "-") for name, _ in names)
    marks = {mark for mark, stands in ((ANY, is_put_together), (REPLACES, REPLACED.search(text))) if stands}
    return frozenset((*WORD.findall(text), *map("".join, names))) | marks
