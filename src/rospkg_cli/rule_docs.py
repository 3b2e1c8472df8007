"""The docs of rules, made of the rules themselves."""

from __future__ import annotations

import json
import textwrap
from collections.abc import Iterable, Iterator
from difflib import SequenceMatcher
from typing import Any

from .example import MARK, Example
from .finding import Safety
from .rule import Profile, Rule
from .rule_address import address

FIX = {Safety.SAFE: "safe (--fix)", Safety.UNSAFE: "unsafe (--fix --unsafe-fixes)", None: "none"}
LANGUAGES = {"py": "python", "xml": "xml", "cfg": "ini", "yaml": "yaml", "txt": "cmake"}
SHORT, AROUND = 9, 2
"""How many lines are shown whole; how many around what matters in longer files."""
SUMMARY_WIDTH = 100
"""Characters: what code scanning pages show of SARIF's shortDescription in one line."""

PROFILES = {
    Profile.DEFAULT: "default",
    Profile.PEDANTIC: "pedantic (with --pedantic, or when selected by name)",
    Profile.RELEASE: "release (with --release, or when selected by name)",
}


def explain(rule: Rule[Any]) -> str:
    """Return the page of a rule, and where it can be read again."""
    place = address(rule.code)
    return page(rule) + (f"\nPage: {place}\n" if place else "")


def page(rule: Rule[Any]) -> str:
    """Return what a rule does, why, its levels, its fix, and its examples, as Markdown."""
    lines = [f"# {rule.code} {rule.name}", ""]
    lines += [f"Severity: {rule.severity.value}" + "".join(f"; {k.value} {v}" for k, v in rule.levels.items())]
    lines += [f"Profile: {PROFILES[rule.profile]}", f"Fix: {FIX[rule.fix]}", f"Since: {rule.since}", ""]
    lines += [textwrap.dedent(rule.docs).strip()]
    for number, example in enumerate(rule.examples, 1):
        lines += ["", f"## Example {number}" if len(rule.examples) > 1 else "## Example", *example_files(example)]
    return "\n".join(lines) + "\n"


def example_files(example: Example) -> Iterator[str]:
    """Yield the bad files and the good ones; of long files only the lines around the difference."""
    if example.targets:
        yield f"For {', '.join(example.targets)}:"
    for path, text in example.bad.items():
        if text is None:
            yield f"`{path}` is not there."
        else:
            yield from code_block(path, with_carets(text), "Bad", lines_marked(text))
    for path, good in example.good.items():
        bad = MARK.sub("", example.bad.get(path) or "")
        if good is None:
            yield f"Good: without `{path}`."
        elif good != bad:
            yield from code_block(path, good.rstrip("\n").split("\n"), "Good", lines_changed(bad, good))


def code_block(path: str, lines: list[str], verdict: str, wanted: set[int]) -> Iterator[str]:
    """Yield a fenced block of the lines near the wanted ones, or of all where there are few."""
    text = "\n".join(lines if len(lines) <= SHORT or not wanted else excerpt(lines, wanted))
    yield f"{verdict} `{path}`{':' if text else ', empty.'}"
    if text:
        yield f"```{LANGUAGES.get(path.rpartition('.')[2], '')}\n{text}\n```"


def excerpt(lines: list[str], wanted: set[int]) -> Iterator[str]:
    example_files = -1
    for number, line in enumerate(lines):
        if any(abs(number - each) <= AROUND for each in wanted):
            if number > example_files + 1:
                yield "…"
            yield line
            example_files = number
    if example_files < len(lines) - 1:
        yield "…"


def with_carets(text: str) -> list[str]:
    """Return the lines of a text with each mark drawn as carets below its line."""
    lines = []
    for line in text.rstrip("\n").split("\n"):
        lines.append(MARK.sub("", line))
        marks = [(m.start() - i, m.group()) for i, m in enumerate(MARK.finditer(line))]
        if marks:
            start = next((at for at, mark in marks if mark == "«"), 0)
            end = next((at for at, mark in marks if mark == "»"), len(lines[-1]))
            lines.append(" " * start + "^" * max(1, end - start))
    return lines


def lines_marked(text: str) -> set[int]:
    """Return the numbers (from 0) of the lines that hold carets, as `underlined` counts them."""
    return {number for number, line in enumerate(with_carets(text)) if line.strip() and not line.strip(" ^")}


def lines_changed(bad: str, good: str) -> set[int]:
    """Return the numbers (from 0) of the lines of `good` that `bad` lacks, or next to which `bad` has more."""
    matcher = SequenceMatcher(None, bad.split("\n"), good.split("\n"), autojunk=False)
    return {
        number
        for tag, _, _, start, end in matcher.get_opcodes()
        if tag != "equal"
        for number in range(start, max(end, start + 1))
    }


def explained_json(rules: Iterable[Rule[Any]], is_list: bool) -> str:
    """Return the docs of a rule as JSON, or of several as a list."""
    found = [{**described(rule), "explanation": explain(rule)} for rule in rules]
    return json.dumps(found if is_list else found[0], indent=2) + "\n"


def rules_text(rules: Iterable[Rule[Any]]) -> str:
    """Return a table of rules, one line each."""
    rows = []
    for rule in rules:
        marks = {Safety.SAFE: "fix", Safety.UNSAFE: "unsafe fix", None: ""}[rule.fix]
        profile = "" if rule.profile is Profile.DEFAULT else f"--{rule.profile.value}"
        rows.append(f"{rule.code}  {rule.name:<32} {rule.severity.value:<8} {marks:<11} {profile}".rstrip())
    return "\n".join(rows) + "\n"


def rules_json(rules: Iterable[Rule[Any]]) -> str:
    """Return rules as JSON."""
    return json.dumps([described(rule) for rule in rules], indent=2) + "\n"


def described(rule: Rule[Any]) -> dict[str, Any]:
    """Return what is known of a rule, as an object of JSON."""
    return {
        "code": rule.code,
        "name": rule.name,
        "severity": rule.severity.value,
        "levels": {level.value: when for level, when in rule.levels.items()},
        "profile": rule.profile.value,
        "fix": rule.fix.value if rule.fix else None,
        "since": rule.since,
        "summary": summary(rule),
        "page": address(rule.code),
    }


def summary(rule: Rule[Any]) -> str:
    """Return the first line of what a rule does: one sentence, at most `SUMMARY_WIDTH` characters."""
    return rule.docs.partition("## What it does")[2].strip().partition("\n")[0]
