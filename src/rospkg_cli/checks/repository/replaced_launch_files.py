"""Launch files that are replaced: by one in another language, or by callers that give an argument another value."""

from __future__ import annotations

import posixpath
import re
from collections.abc import Iterator

from ...files import PackageFiles
from ...lazy_regex import regex
from ...package.file_role import role_of
from ...package.launch.live_text import live_text
from .pages_and_scripts import pages_and_scripts

ENDING = regex(r"(?:[._-]?launch)?(?:\.(?:py|xml|ya?ml|launch))+$")
"""What a launch file is called behind its own name."""
ARGUMENT = regex(
    r"DeclareLaunchArgument\s*\(\s*(?:name\s*=\s*)?[\"'](\w+)[\"'](?:(?!DeclareLaunchArgument)[^()]){0,200}default_value\s*=\s*"
    r"[\"']?\Z|<arg\b[^<>]{0,100}\bname\s*=\s*[\"'](\w+)[\"'][^<>]{0,100}\bdefault\s*=\s*[\"']\Z"
)
"""What stands before the default of an argument of a launch file."""
LONGEST = 500


def has_named_twin(path: str, files: PackageFiles) -> bool:
    """Return whether only another launch file is named, of the same name and folder, but in another language."""
    folder, name = posixpath.split(path)
    stem = ENDING.sub("", name)
    siblings = (each for each in files.paths if each != path and posixpath.dirname(each) == folder)
    twins = [
        each for each in siblings if role_of(each) == "launch" and ENDING.sub("", posixpath.basename(each)) == stem
    ]
    return bool(stem and twins) and not is_named(path, files) and any(is_named(each, files) for each in twins)


def is_named(path: str, files: PackageFiles) -> bool:
    return any(True for _ in callers(path, files))


def is_always_given(path: str, before: str, files: PackageFiles) -> bool:
    """Return whether what stands behind a text is the default of an argument that all callers of the file give."""
    found = ARGUMENT.search(before[-LONGEST:])
    if found is None:
        return False
    name = found[1] or found[2]
    given = re.compile(rf"(?<!\w){name}:=|[\"']{name}[\"']\s*[,:]|name\s*=\s*[\"']{name}[\"'][^<>]*\bvalue\s*=")
    calls = list(callers(path, files))
    return bool(calls) and all(given.search(each) for each in calls)


def callers(path: str, files: PackageFiles) -> Iterator[str]:
    """Yield each line of a page or a script, and each launch file of the run, that names a launch file."""
    word = re.compile(rf"(?<![\w-]){re.escape(posixpath.basename(path))}(?!\w)")
    whole = PackageFiles(files.whole) if files.whole is not None else files
    own = posixpath.join(files.folder, path) if whole is not files else path
    for page in pages_and_scripts(files):
        yield from (line for line in page.replace("\\\n", " ").splitlines() if word.search(line))
    for each in whole.every:
        if each != own and role_of(each) == "launch" and word.search(whole.readable_text(each)):
            text = live_text(whole, each)
            yield from (text,) if word.search(text) else ()
