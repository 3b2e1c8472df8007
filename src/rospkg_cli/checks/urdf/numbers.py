"""Numbers in URDF, read as urdfdom reads them: by C++ streams in the classic locale, vectors split at single blanks."""

from __future__ import annotations

from ...lazy_regex import regex

NUMBER = regex(r"[ \t\n\r\f\v]*[+-]?(?:[0-9]+\.?[0-9]*|\.[0-9]+)(?:[eE][+-]?[0-9]+)?")


def is_number(text: str) -> bool:
    return NUMBER.fullmatch(text) is not None and abs(float(text)) != float("inf")


def vector_fault(text: str, size: int) -> str | None:
    """Return why a text is no vector of a size; None where it is one."""
    parts = [part for part in text.split(" ") if part]
    wrong = next((part for part in parts if not is_number(part)), None)
    if wrong is not None:
        return f"`{wrong.strip() or repr(wrong)}` is no number"
    if len(parts) != size:
        return f"it has {len(parts)} numbers instead of {size}"
    return None
