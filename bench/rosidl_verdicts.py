"""Ask the real rosidl whether it builds interface files, one JSON line [kind, name, text] at a time.

Runs under the Python that has rosidl_adapter and rosidl_parser (Debian: python3-rosidl, /usr/bin/python3), and prints
one JSON line for each: null, or the error.  What the adapter writes is read back as rosidl_parser reads it.
"""

from __future__ import annotations

import contextlib
import io
import json
import sys
from typing import Any

from rosidl_adapter.parser import (  # type: ignore[import-not-found]
    parse_action_string,
    parse_message_string,
    parse_service_string,
)
from rosidl_adapter.resource import evaluate_template  # type: ignore[import-not-found]
from rosidl_parser.parser import parse_idl_string  # type: ignore[import-not-found]

READERS = {"msg": parse_message_string, "srv": parse_service_string, "action": parse_action_string}


def build(kind: str, name: str, text: str) -> None:
    """Adapt one file and parse what comes of it; raises whatever rosidl raises."""
    data: dict[str, Any] = {"pkg_name": "my_pkg", "relative_input_file": f"{kind}/{name}.{kind}"}
    data[kind] = READERS[kind]("my_pkg", name, text)
    written = evaluate_template(f"{kind}.idl.em", data).encode("iso-8859-1")
    parse_idl_string(io.TextIOWrapper(io.BytesIO(written), encoding="utf-8").read())


def verdict(kind: str, name: str, text: str) -> str | None:
    said = io.StringIO()
    with contextlib.redirect_stderr(said):
        try:
            build(kind, name, text)
        except (Exception, SystemExit) as error:
            return f"{type(error).__name__}: {error} {said.getvalue()[-200:]}".replace("\n", " ")
    return None


for line in sys.stdin:
    print(json.dumps(verdict(*json.loads(line))), flush=True)
