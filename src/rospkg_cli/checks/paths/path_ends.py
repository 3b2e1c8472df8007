"""What calls do with a path that they are given: make it, write there, look at it, or read what is there."""

from __future__ import annotations

from typing import Literal

from ...lazy_regex import regex

End = Literal["made", "written", "shown", "read", "unknown", "path"]
"""Of `path` nothing became yet: what is called returns a path that begins with it, or is it."""

PATHS = frozenset({
    "join", "joinpath", "Path", "PurePath", "path", "str", "string", "fspath", "expanduser", "abspath", "realpath",
    "normpath", "format", "c_str", "generic_string", "native", "resolve", "absolute", "with_suffix", "with_name",
    "rstrip", "strip", "value", "string_value", "get_parameter_value", "as_string", "get_value", "parent", "move",
    "parent_path", "dirname", "get_parameter", "lexically_normal", "canonical", "weakly_canonical", "as_posix",
    "get",
})  # fmt: skip
JOINS = frozenset({"join", "joinpath", "with_suffix", "with_name"})
MAKES = regex(r"(?:makedirs|mkdir|mkpath|create_director(?:y|ies)|ensure_(?:dir|folder|path)\w*)")
WRITES = regex(
    r"(?i)(?:im)?(?:save|write|dump|export|record)\w*|to_(?:csv|json|excel|pickle|parquet|yaml)|touch|\w*FileHandler"
    r"|ofstream|basicConfig|VideoWriter\w*|basic_file_sink\w*|basic_logger\w*"
)
OPENS = frozenset({"open", "fopen", "freopen", "ZipFile", "fstream", "File", "FileStorage"})
WRITE_MODE = regex(
    r"[\"'][wax][bt+]{0,2}[\"']|\bios(?:_base)?\s*::\s*(?:out|app)\b|\bFileStorage\s*::\s*(?:WRITE|APPEND)"
)
COPIES = frozenset({"copy", "copy2", "copyfile", "copytree", "copy_file", "symlink"})
"""What reads its first path and writes the second one."""
LOOKS = regex(
    r"print|printf|fprintf|debug|info|warn|warning|error|fatal|critical|log|RCLCPP_\w+|ROS_\w+|puts|len|isinstance|if|elif"
    r"|while|assert|\w*Error|Exception|exists|is_?(?:file|dir|directory|absolute)|empty|size|length|name|stem|filename"
    r"|type|bool|repr|print_\w+|disk_usage|space|assert\w*|perror|throw|what|setText|exist"
)
"""Whatever shows a path, or asks something of it that does not fail."""
READS = regex(r"(?i)\w*(?:load|read|ifstream|listdir|scandir|glob|walk|iterdir|directory_iterator|parse|import)\w*")
COMMAND = regex(r"\bmap_saver\w*[^;]*[\s\"']-f$|\bbag\b[\s\"',]+record\b[^;]*[\s\"'](?:-o|--output)$")
"""A command line, as one text or in parts, up to what it writes."""
FILLED = regex(r"(?:%s|\{\})?[\"']\s*(?:%|\.format\()\s*$")
"""A text whose last word is what follows: `"-f %s" % path`."""


def end_in(name: str, arguments: str) -> End:
    """Return what becomes of a path among the arguments of a function of a name."""
    if name in PATHS:
        return "path"
    if MAKES.fullmatch(name):
        return "made"
    if name in OPENS:
        return "written" if WRITE_MODE.search(arguments) else "read"
    if LOOKS.fullmatch(name):
        return "shown"
    if WRITES.fullmatch(name):
        return "written"
    return "read" if READS.fullmatch(name) else "unknown"
