"""Filters of templates for lines of code: the order of imports and includes, lines that are too long."""

from __future__ import annotations

from .user_text import WIDTH


def in_order(lines: str) -> str:
    """Sort import lines as Google's style wants them: by module, whatever the form."""
    imports = merged([line for line in lines.splitlines() if line.strip()])
    return "".join(f"{line}\n" for line in sorted(imports, key=lambda line: line.split()[1].lower()))


def merged(imports: list[str]) -> list[str]:
    """Put what several lines import from one module into one of them."""
    found: dict[str, list[str]] = {}
    for line in imports:
        module, _, names = line.partition(" import ")
        found.setdefault(module, []).extend(names.split(", ") if names else [])
    several = {module for module in found if sum(line.startswith(f"{module} import ") for line in imports) > 1}
    lines = (f"{module} import {', '.join(sorted(set(found[module]), key=str.lower))}" for module in several)
    return [*(line for line in imports if line.partition(" import ")[0] not in several), *lines]


def includes(lines: str) -> str:
    """Put the headers of the standard library first, then the others, each group sorted, as ament's cpplint wants."""
    found = sorted(line for line in lines.splitlines() if line.strip())
    standard = [line for line in found if "<" in line]
    return "\n".join([*standard, "", *(line for line in found if line not in standard)]) + "\n"


def long_line(line: str) -> str:
    """Return a line of Python that can't be broken, excused where it is too long."""
    return line if len(line) <= WIDTH else f"{line}  # noqa: E501"
