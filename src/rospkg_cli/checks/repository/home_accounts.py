"""Accounts that many people have, or that come with the container of a repository: their homes are not personal."""

from __future__ import annotations

import re

from ...files import PackageFiles
from ...lazy_regex import regex
from .container_files import OF_CONTAINER, files_called

OF_MANY = frozenset(
    "admin app dev developer docker jetson nvidia pi robot root ros ros2 runner ubuntu user username vscode you".split()
)
"""Accounts that robots, containers and examples have: the path may be the same for everyone."""
SHARED = regex(r"your|docker|container|(?:^|_)(?:ws|workspace)$")
OF_UNIT = regex(r"\.service(?:\.in)?$")
RUNS_AS = r"(?m)^User[ \t]*=[ \t]*{0}[ \t]*$"
"""The account that systemd starts a program of the repository as."""
SHORTEST = 4
"""The letters of a name that is no part of other words; a shorter one must be written as that of an account."""
OF_MACHINE = regex(
    r"(?i)(?:^|/)(?:vagrantfile|user-data|[^/]*cloud[_-]?init[^/]*|[^/]*entry_?-?point[^/]*\.(?:sh|bash)"
    r"|(?:[^/]*docker[^/]*|\.?devcontainers?|containers?|ansible)/(?:.*/)?[^/.]*(?:\.(?:sh|bash|ya?ml|json|env|cfg|conf))?"
    r"|\.env)$"
)
"""Scripts and settings of containers and machines that everybody gets alike: they may name other people too."""
WRITTEN = r"/home/{0}(?![\w.-])(?![^\s:\"']*:[/$.~])|(?i:user|chown|gosu)[^\n]*?(?<![\w./-]){0}(?![\w.-])"
"""A home, which is not that of the host in `-v /home/ada/ws:/ws`, or the name of an account: `useradd -m neo`."""


def is_of_many(user: str) -> bool:
    """Return whether many have an account of that name; a workspace right below /home is that of a container."""
    lower = user.lower()
    return lower in OF_MANY or SHARED.search(lower) is not None or lower.startswith(("user", "my_", "<"))


def is_of_container(files: PackageFiles, user: str) -> bool:
    """Return whether what makes containers or machines, in the package or elsewhere in the run, names an account."""
    if not user.isascii():
        return False
    written = re.compile(WRITTEN.format(re.escape(user)))
    for each, path in files_called(files, OF_CONTAINER, OF_MACHINE):
        if each.holds(path, user.encode()):
            is_clear = len(user) >= SHORTEST and OF_CONTAINER.search(path) is not None
            if is_clear or written.search(each.readable_text(path)):
                return True
    as_unit = re.compile(RUNS_AS.format(re.escape(user)))
    return any(as_unit.search(each.readable_text(path)) for each, path in files_called(files, OF_UNIT))
