"""Texts whose comments are blanks, so that a pattern finds only what counts; places stay where they are."""

from __future__ import annotations

import re

DOCSTRING = r"\"\"\"(?:\\.|[^\\])*?\"\"\"|'''(?:\\.|[^\\])*?'''"
PYTHON = rf"(?P<off>{DOCSTRING})|\"(?:\\.|[^\"\\\n])*\"|'(?:\\.|[^'\\\n])*'|(?P<comment>#[^\n]*)"
HASH = r"\"(?:\\.|[^\"\\])*\"|(?P<off>#\[(=*)\[.*?\]\2\])|(?P<comment>#[^\n]*)"
YAML = r"\"(?:\\.|[^\"\\\n])*\"|'[^'\n]*'|(?P<comment>(?:^|(?<=\s))#[^\n]*)(?P<off>\Z\A)?"
CPP = r"\"(?:\\.|[^\"\\\n])*\"|(?P<off>/\*.*?\*/)|(?P<comment>//[^\n]*)"
XML = r"(?P<off><!--.*?-->)(?P<comment>\Z\A)?"
INTERFACE = r"(?P<comment>#[^\n]*)(?P<off>\Z\A)?"
KINDS = {
    ".py": PYTHON,
    ".cfg": r"(?P<comment>^[#;][^\n]*)(?P<off>\Z\A)?",
    ".cmake": HASH,
    "CMakeLists.txt": HASH,
    ".yaml": YAML,
    ".yml": YAML,
    ".hpp": CPP,
    ".h": CPP,
    ".cpp": CPP,
    ".xml": XML,
    ".urdf": XML,
    ".xacro": XML,
    ".launch": XML,
    ".msg": INTERFACE,
    ".srv": INTERFACE,
    ".action": INTERFACE,
}
COMPILED = {ending: re.compile(pattern, re.DOTALL | re.MULTILINE) for ending, pattern in KINDS.items()}


def without_comments(file: str, text: str) -> str:
    pattern = next((COMPILED[ending] for ending in COMPILED if file.endswith(ending)), None)
    return pattern.sub(blank, text) if pattern else text


def blank(match: re.Match[str]) -> str:
    if match["comment"] is None and match["off"] is None:
        return match[0]
    return re.sub(r"[^\n]", " ", match[0])
