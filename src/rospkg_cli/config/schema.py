"""The keys of the config and the types of their values; an error is one sentence with line and column."""

from __future__ import annotations

import re
from collections.abc import Callable, Mapping
from pathlib import Path
from typing import Any

from ..ros.distros import DISTROS
from ..sentence import single_line
from ..suggest import did_you_mean
from ..user_error import UserError

LONGEST_KEY = 1_000
"""Characters; no key is longer, and compiling a pattern of a longer one is slow."""

SEVERITIES = ("error", "warning", "info", "off")


class ConfigError(UserError):
    """A config that can't be used; the message begins with the file and the place."""

    def __str__(self) -> str:
        """The message on one line, with control characters escaped."""
        return single_line(super().__str__())


def strings(value: Any) -> tuple[str, ...]:
    if not isinstance(value, list) or not all(isinstance(v, str) for v in value):
        raise ValueError("must be a list of strings")
    return tuple(value)


def reasons(value: Any) -> dict[str, str]:
    if not isinstance(value, dict) or not all(isinstance(v, str) and v.strip() for v in value.values()):
        raise ValueError('must give a reason for each rule: ignore = { SET304 = "we stay on Humble" }')
    return dict(value)


def severities(value: Any) -> dict[str, str]:
    if not isinstance(value, dict) or not all(v in SEVERITIES for v in value.values()):
        raise ValueError(f"must be one of {', '.join(SEVERITIES)} for each rule")
    return dict(value)


def distros(value: Any) -> tuple[str, ...]:
    names = [each.name for each in DISTROS]
    for name in strings(value):
        if name not in names:
            raise ValueError(f"knows no distribution `{name}`{did_you_mean(name, names)}; there are {', '.join(names)}")
    return strings(value)


def boolean(value: Any) -> bool:
    if not isinstance(value, bool):
        raise ValueError("must be true or false")
    return value


def level(value: Any) -> str:
    if value not in SEVERITIES[:3]:
        raise ValueError(f"must be one of {', '.join(SEVERITIES[:3])}")
    return str(value)


def text(value: Any) -> str:
    if not isinstance(value, str):
        raise ValueError("must be a string")
    return value


Form = Callable[[Any], Any] | Mapping[str, Any]

INDEX: Mapping[str, Form] = {"source": text, "distros": distros}
NEW: Mapping[str, Form] = dict.fromkeys(
    ("distro", "email", "launch", "license", "maintainer", "tests", "version"), text
)
SECTION: Mapping[str, Form] = {"ignore": reasons, "severity": severities}
FORMS: Mapping[str, Form] = {
    "select": strings,
    "extend-select": strings,
    "ignore": reasons,
    "severity": severities,
    "target": distros,
    "exclude": strings,
    "build-types": strings,
    "plugins": strings,
    "pedantic": boolean,
    "release": boolean,
    "fail-on": level,
    "required-version": text,
    "per-package": {"*": SECTION},
    "per-path": {"*": SECTION},
    "new": NEW,
    "index": INDEX,
}


def read_section(
    data: Any, forms: Mapping[str, Form], path: Path, source: str, table: tuple[str, ...]
) -> dict[str, Any]:
    """Return the values of a table, checked; raises ConfigError."""
    found: dict[str, Any] = {}
    if not isinstance(data, dict):
        raise ConfigError(f"{key_position(path, source, table[:-1], table[-1])}: `{table[-1]}` must be a table")
    for key, value in data.items():
        form = forms.get("*", forms.get(key))
        if form is None:
            message = f"there is no key `{key}`{did_you_mean(key, forms)}; there are {', '.join(sorted(forms))}"
            raise ConfigError(f"{key_position(path, source, table, key)}: {message}")
        if isinstance(form, Mapping):
            found[key] = read_section(value, form, path, source, (*table, key))
            continue
        try:
            found[key] = form(value)
        except ValueError as error:
            raise ConfigError(f"{key_position(path, source, table, key)}: `{key}` {error}") from None
    return found


def key_position(path: Path, source: str, table: tuple[str, ...], key: str) -> str:
    """Return `file:line:column` of a key, as near as it can be found: in its table, else anywhere."""
    if len(key) > LONGEST_KEY:
        return f"{path}:1:1"
    own, current = re.compile(rf"""\s*["']?{re.escape(key)}["']?\s*[=.\]]"""), ""
    wanted, anywhere = ".".join(table), ""
    for number, line in enumerate(source.splitlines(), 1):
        begin, bracket, _ = line.strip().partition("]")
        if bracket and begin.startswith("["):
            current = re.sub(r"""["'\s]""", "", begin.lstrip("["))
            if current == ".".join((*table, key)):
                return f"{path}:{number}:{line.index('[') + 1}"
        elif own.match(line) and (current == wanted or not anywhere):
            anywhere = f"{path}:{number}:{len(line) - len(line.lstrip()) + 1}"
            if current == wanted:
                return anywhere
    return anywhere or f"{path}:1:1"
