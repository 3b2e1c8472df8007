"""Who writes: as asked for, else as git knows, else from the login."""

from __future__ import annotations

import getpass
import re
import socket
import subprocess
from pathlib import Path

from ..light_dataclasses import dataclass
from ..ros.manifest import EMAIL
from . import ScaffoldError
from .user_text import UserText, user_text

LONGEST = 80
"""The copyright line holds the name, and ament_copyright wants it on one line."""

CMAKE_SYNTAX = re.compile(r'["\\$]')
"""What ament_cmake, which copies the name into CMake code as it stands, would stumble over."""

CODING = re.compile(r"coding[:=]")


@dataclass(frozen=True)
class Maintainer:
    name: UserText
    email: str
    guessed: bool
    """Whether the address is made from login and host."""


def find_maintainer(name: str, email: str, folder: Path) -> Maintainer:
    """Return the maintainer; "" for what was not given. Raises ScaffoldError for what can't be used."""
    maintainer = checked_name(name or from_git("user.name", folder) or login())
    if email and not EMAIL.fullmatch(email):
        raise ScaffoldError(f"`{email}` is no e-mail address that package.xml may hold; write one as ada@example.org")
    known = email or from_git("user.email", folder)
    usable = bool(EMAIL.fullmatch(known))
    return Maintainer(maintainer, known if usable else local_address(), not usable)


def checked_name(name: str) -> UserText:
    found = user_text("the maintainer's name", name)
    if not found.text:
        raise ScaffoldError("the maintainer's name is empty; give one with --maintainer")
    if len(found.text) > LONGEST:
        raise ScaffoldError(
            f"the maintainer's name has {len(found.text)} characters; the header has room for {LONGEST}"
        )
    if CODING.search(found.text):
        raise ScaffoldError("a maintainer's name with `coding:` would make Python misread every header; leave that out")
    return found


def check_for_cmake(name: UserText) -> None:
    """Raise ScaffoldError for a name that a package which CMake builds can't have."""
    if found := CMAKE_SYNTAX.search(name.text):
        reason = "ament_cmake would copy it into CMake code, unescaped"
        raise ScaffoldError(f"the maintainer's name holds `{found.group()}`, and {reason}; leave it out")


def from_git(key: str, folder: Path) -> str:
    """Return a value of git's config as it holds in a folder; "" where there is no git or no value."""
    while not folder.is_dir():
        folder = folder.parent
    command = ["git", "config", "--get", key]
    try:
        found = subprocess.run(command, cwd=folder, capture_output=True, text=True, check=False, timeout=10)
    except (OSError, UnicodeError, subprocess.TimeoutExpired):
        return ""
    return found.stdout.strip() if found.returncode == 0 else ""


def login() -> str:
    try:
        return getpass.getuser()
    except (OSError, KeyError, ImportError):  # no such user: which one it is depends on the Python
        return "user"


def local_address() -> str:
    """Return `login@host.local`, in the characters that catkin_pkg allows."""
    host = socket.gethostname().partition(".")[0]
    return f"{plain_word(login()) or 'user'}@{plain_word(host) or 'localhost'}.local"


def plain_word(text: str) -> str:
    return re.sub(r"[^a-z0-9]+", "-", text.lower()).strip("-")
