"""What the build file that colcon ignores would install, and the other one does not: by their texts."""

from __future__ import annotations

import posixpath
import re

from ...files import PackageFiles
from ...lazy_regex import regex
from ...package.file_role import role_of
from ...ros.share_layout import FOLDERS

COMMENT = regex(r"#[^\n]*")
INSTALL = regex(r"\binstall\w*\s*\(([^)]*)", re.IGNORECASE)
"""The arguments of `install()`, or of a command that is named after it."""
WORD = regex(r"[^\s\"';()]+")
ENTRY = regex(r"[\"'\s=]([\w.]+)\s*:\s*\w+\s*[\"'\n]")
"""The module of an entry point."""


def lost_of_cmake(files: PackageFiles) -> list[str]:
    """Return what a CMakeLists.txt installs and setup.py does not name: files, folders, and its targets at the end."""
    text, setup = (COMMENT.sub("", files.readable_text(path)) for path in ("CMakeLists.txt", "setup.py"))
    found, targets = dict[str, None](), False
    for arguments in INSTALL.findall(text):
        words = [word.rstrip("/") for word in WORD.findall(arguments)]
        targets |= "TARGETS" in words
        found |= dict.fromkeys(word for word in words if word in files.places and not names(setup, word))
    return [*found, *(["targets"] if targets else [])]


def is_told_elsewhere(path: str) -> bool:
    """Return whether a path is in a folder that setup.py has to install: launch files, parameters and the like."""
    return path.partition("/")[0] in FOLDERS


def lost_of_setup(files: PackageFiles) -> bool:
    """Return whether setup.py or setup.cfg starts or installs what is there, and no rule of CMakeLists.txt names it."""
    cmake = "\n".join(INSTALL.findall(COMMENT.sub("", files.readable_text("CMakeLists.txt"))))
    text = "\n".join(COMMENT.sub("", files.readable_text(path)) for path in ("setup.py", "setup.cfg"))
    if "generate_distutils_setup" in text:
        return False
    shared = (folder for folder in FOLDERS if folder in files.folders and names(text, folder))
    return any(not names(cmake, path) for path in (*modules_of(files, text), *shared))


def modules_of(files: PackageFiles, text: str) -> list[str]:
    """Return the modules that the entry points in a text start; without any, all in Python packages."""
    modules = [path for path in files.paths if path.endswith(".py") and "/" in path and role_of(path) == "run"]
    if started := [f"/{each.replace('.', '/')}.py" for each in ENTRY.findall(text)]:
        return [path for path in modules if f"/{path}".endswith(tuple(started))]
    inner = (path for path in modules if files.exists(posixpath.join(posixpath.dirname(path), "__init__.py")))
    return [path for path in inner if not path.endswith("/__init__.py")]


def names(text: str, path: str) -> bool:
    """Return whether a text names a file or folder, or its folder."""
    folder, _, name = path.rpartition("/")
    return any(re.search(rf"(?<![\w-]){re.escape(each)}(?![\w-])", text) for each in (name, folder) if each)
