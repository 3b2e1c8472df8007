"""Paths at which a dialog for files begins: where there is no such folder, it begins elsewhere, and nothing is lost."""

from __future__ import annotations

from ...lazy_regex import regex

DIALOG = regex(
    r"\b(?:QFileDialog(?:(?:::|\.)\w+)?|Q?FileDialog|DirDialog|getOpenFileNames?|getSaveFileName|getExistingDirectory|"
    r"setDirectory|ask(?:open|saveas)(?:file(?:name)?s?)?|askdirectory|set_current_folder)\s*(?:\w+\s*)?(?P<given>\()"
)
GIVEN = regex(r"\b(?:initialdir|initial_?dir(?:ectory)?|defaultDir)[\"']?\s*[=:]\s*[rRfFuU]?[\"']?$")
NEAR = 400
"""How many characters of a call stand before its path at most."""


def begins_dialog(text: str, place: int) -> bool:
    """Return whether a path at a place of code is the folder in which a dialog begins."""
    before = text[max(0, place - NEAR) : place]
    if GIVEN.search(before):
        return True
    calls = (before[match.end("given") :] for match in DIALOG.finditer(before))
    return any(";" not in each and is_open(each) for each in calls)


def is_open(arguments: str) -> bool:
    """Return whether a call does not end in some text that begins with its arguments."""
    depth = 1
    for each in arguments:
        depth += (each == "(") - (each == ")")
        if not depth:
            return False
    return True
