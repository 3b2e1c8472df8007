"""The names of packages that the variables and launch arguments of a text hold."""

from __future__ import annotations

from ...lazy_regex import regex

NAMED = regex(r"(?m)^[ \t]*(\w+)[ \t]*(?::[^=\n]*)?=[ \t]*[\"']([\w-]+)[\"']")
DECLARED = regex(
    r"\bDeclareLaunchArgument\(\s*(?:name\s*=\s*)?[\"'](\w+)[\"']\s*,"
    r"(?:(?!DeclareLaunchArgument)[\s\S]){0,400}?\bdefault_value\s*=\s*(?:[\"']([\w-]+)[\"']|(\w+)\s*[,)])?"
)
"""A launch argument, with the text of its default or the variable that holds it; neither where it is another value."""
ASKED = r"LaunchConfiguration\(\s*(?:variable_name\s*=\s*)?[\"'](\w+)[\"']|launch_configurations\[\s*[\"'](\w+)[\"']"
BOUND = regex(
    r"(?m)^[ \t]*(\w+)[ \t]*(?::[^=\n]*)?=[ \t]*(?:context\.perform_substitution\(\s*|context\.)?"
    rf"(?:{ASKED}|(\w+)(?=\.perform\(|\)[ \t]*$))"
)
"""A variable that gets the value of an argument, or of another variable that holds one."""


def held_names(text: str) -> dict[str, str]:
    """Return what variables hold that are given a literal name, or the value of an argument whose default is one."""
    held = {match[1]: match[2] for match in NAMED.finditer(text)}
    defaults = argument_defaults(text, held)
    for match in BOUND.finditer(text) if defaults else ():
        argument = match[2] or match[3]
        value = defaults.get(argument) if argument else held.get(match[4])
        if value:
            held[match[1]] = value
    return held


def argument_defaults(text: str, held: dict[str, str] | None = None) -> dict[str, str]:
    """Return the default of each launch argument that has one, and the same wherever it is declared."""
    if held is None:
        held = {match[1]: match[2] for match in NAMED.finditer(text)}
    found: dict[str, set[str]] = {}
    for match in DECLARED.finditer(text):
        found.setdefault(match[1], set()).add(match[2] or held.get(match[3] or "", ""))
    return {name: next(iter(defaults)) for name, defaults in found.items() if len(defaults) == 1}
