"""Messages on headers that users of a package do not find (CMK106)."""

from __future__ import annotations

from ..enumeration import in_ticks
from .exported_include_folders import UnexportedFolder
from .private_includes import PrivateInclude


def not_exported(each: UnexportedFolder) -> str:
    others = f"the package exports {in_ticks(each.exported)} alone" if each.exported else "no command exports it"
    stops = f"`#include <{each.header}>` stops in packages that use this one"
    wanted = f"write `$<INSTALL_INTERFACE:{each.folder}>`" if each.is_set_by_target else f"export `{each.folder}`"
    return f"the headers land in `{each.folder}/`, but {others}: {stops}; {wanted}"


def private(each: PrivateInclude, others: int) -> str:
    more = f" (and {others} more)" if others else ""
    start = f"`{each.include.path}`{more} is not installed, and `{each.file.path}`, which is, includes it"
    return f'{start}: users stop with "No such file"; install it, or include it in sources alone'


def lacking(path: str, user: str) -> str:
    stops = f'`{path}` is not installed, and `{user}` includes it: the compiler stops with "No such file"'
    return f"{stops}; add it to an `install(…)` for headers"
