"""Findings on something missing that a comment or page asks readers to write, as exercises do."""

from __future__ import annotations

import re
from pathlib import PurePosixPath

from ...checks.paths.home_path_texts import without_comments
from ...checks.python.left_blank import asks_to, is_asked_at, is_asked_for
from ...checks.repository.pages_and_scripts import own_pages, pages_above
from ...checks.repository.settings_to_change import comments_at
from ...files import PackageFiles
from ...finding import Finding
from ...lazy_regex import regex
from ...ros.interfaces import KINDS
from .milder import RuleResults, as_infos

OF_MISSING = frozenset(
    (
        "CMK102 CMK108 CMK110 IDL006 IDL011 LCH002 LCH003 LCH008 LCH011 PLG002 PRM007 PRM008 SET101 SET205 "
        "URD001 URD002"
    ).split()
)
"""Rules about names of something that does not exist."""
OF_PROGRAMS = (r"install (?:your |the |all )*(?:targets?|executables?|nodes?|programs?|scripts?)\b", "CMakeLists.txt")
OF_COMPONENTS = (r"register (?:your |the |a |all )*(?:components?|nodes?|class)\b", "CMakeLists.txt")
OF_DEPENDENCIES = (r"(?:add|declare|list|specify|fill in|complete) (?:[\w-]+ ){0,3}dependenc(?:y|ies)\b", "package.xml")
TASKS = {
    **dict.fromkeys(("CMK103", "CMK112"), OF_PROGRAMS),
    "CMK108": OF_COMPONENTS,
    **dict.fromkeys(("DEP101", "DEP103", "DEP104", "DEP105"), OF_DEPENDENCIES),
}
"""Rules about what a file does not do, with the words by which a comment in it says that this is still to be done."""
OF_FIELDS = frozenset({"IDL010", "IDL013"})
FIELDS = (
    r"(?:add|define|declare|write|complete|fill in|specify) (?:[\w-]+ ){0,3}(?:fields?|request|response|goal|result)\b"
)
ONE = r"(?:add|append|define|declare|include) (?:[\w-]+ ){{0,2}}[`'\"]?{0}\b"
ADDS = (
    r"(?i)\b(?:add|append|define|declare|write|include)\b[^\n]*"
    r"(?:\bfields?\b[ :]*(?:(?:named|called|and|`[^`\n]+`)[ ,]*)*`{0}`|`{0}`(?: \w+)? fields?\b)"
)
"""How a page has people add a field of a name to a message."""
UNUSED = (
    r"\b(?:unused|not (?:yet |currently )?(?:used|supported|implemented|read)|no longer (?:used|read|supported)"
    r"|deprecated|obsolete|has no effect)\b"
)
"""How a comment says of a value or a block that nothing reads it now."""
OF_VALUES = {"PRM003": rf"{UNUSED}|\b(?:rename|change) (?:this|it|to)\b", "PRM007": UNUSED}
BY_COMMENT = "; a comment says that nothing reads it, or to change it"
OF_TYPES = "IDL011"
IN_MESSAGE = "; a comment in the message says that its fields are still to be written"
ALL = frozenset(OF_VALUES.keys() | OF_FIELDS | OF_MISSING | TASKS.keys())
NAMED = regex("`([^`]+)`")
MAX_NAMES = 2
WHY = "; a comment says that it is still to be written"
OF_FILES = frozenset({"CMK102", "IDL006", "IDL011", "SET101"})
WRITES = regex(r"(?i)\b(?:write|create|implement|complete|touch|nano|gedit|vim?)[ \t`*:]")
"""Words of a line that ask people to make the file whose name follows."""
BY_PAGE = "; a page has people write it"
OF_WHOLE = "; a comment in {} says that this is still to be done"


def as_announced(results: RuleResults, files: PackageFiles, package: str) -> RuleResults:
    """Return the results of a package with an info for what a comment or page asks readers to write."""
    return as_infos(results, ALL, lambda found: why_left(found, files, package))


def why_left(found: Finding, files: PackageFiles, package: str) -> str:
    if found.code in TASKS:
        task, path = TASKS[found.code]
        if asks_to(files.readable_text(path), task):
            return OF_WHOLE.format(f"`{path}`")
    if found.code in OF_FIELDS:
        return why_without_field(found, files)
    path = str(PurePosixPath(found.location.path).relative_to(files.folder or "."))
    if found.code in OF_VALUES and path.endswith((".yaml", ".yml")):
        text = files.readable_text(path)
        said = comments_at(text, without_comments(path, text), found.location.span.start)
        if any(re.search(OF_VALUES[found.code], each, re.IGNORECASE) for each in said):
            return BY_COMMENT
    text = files.readable_text(path) if found.code in OF_MISSING else ""
    names = [name for name in NAMED.findall(found.message)[:MAX_NAMES] if name != package]
    parts = {part for name in names for part in (name, re.split(r"[./:]+", name.partition(".py")[0])[-1], last(name))}
    asked = (is_asked_for(text, part) or is_asked_at(text, found.location.span.start, part) for part in parts if part)
    if text and any(asked):
        return WHY
    if found.code == OF_TYPES:
        names = [f"{last(NAMED.findall(found.message)[1])}.{kind}" for kind in KINDS]
    else:
        names = names[:1]
    is_written = found.code in OF_FILES and any(is_written_by_people(files, each, found.code) for each in names)
    return BY_PAGE if is_written else ""


def why_without_field(found: Finding, files: PackageFiles) -> str:
    """Return the end of a message on a missing field that a comment or a page has people add; "" for others."""
    message, *names = NAMED.findall(found.message) or [""]
    if asks_for_fields(files, message):
        return IN_MESSAGE
    code = files.readable_text(str(PurePosixPath(found.location.path).relative_to(files.folder or ".")))
    for name in names[:1]:
        task = ONE.format(re.escape(name))
        if any(is_asked_for(text, name) or asks_to(text, task) for text in (code, *texts_of(files, message))):
            return WHY
        adds = re.compile(ADDS.format(re.escape(name)))
        if any(adds.search(text) for text in (*own_pages(files), *pages_above(files))):
            return BY_PAGE
    return ""


def asks_for_fields(files: PackageFiles, message: str) -> bool:
    """Return whether a comment in the file of a message, service or action asks for its fields."""
    return any(asks_to(text, FIELDS) for text in texts_of(files, message))


def texts_of(files: PackageFiles, message: str) -> list[str]:
    """Return the texts of the files that a message, service or action may come from."""
    package, _, rest = message.partition("/")
    kind, _, name = rest.partition("/")
    path = f"{kind}/{name.partition('_')[0]}.{kind}"
    whole = PackageFiles(files.whole) if files.whole is not None else files
    places = [each for each in whole.every if each == path or each.endswith(f"{package}/{path}")] if kind else []
    return [whole.readable_text(each) for each in places]


def is_written_by_people(files: PackageFiles, name: str, code: str) -> bool:
    """Return whether a page has people write a file, or open it in an editor as a new one."""
    file = f"{name.rpartition('.')[2]}.py" if code == "SET101" else last(name)
    own = re.compile(rf"(?<![\w.-]){re.escape(file)}(?![\w-])")
    texts = (*own_pages(files), *pages_above(files))
    lines = (line for text in texts for line in text.split("\n") if own.search(line))
    return any(WRITES.search(own.split(line)[0]) for line in lines)


def last(path: str) -> str:
    return PurePosixPath(path).name
