"""Compare our verdict on package.xml files, real and broken ones, with the official schemas and with catkin_pkg.

    python -m bench.manifest_parity --xsd REP/xsd [--mutations N] [--seed S] FOLDER...

Counted over all different package.xml below the folders, and over N broken copies of them:
- our schema against the official one of the same format: every disagreement has a known reason, or is an accident;
- what catkin_pkg or the official schema refuses and we say nothing about: a miss;
- findings that claim that colcon refuses the manifest, or that the schema does, while they don't: a lie.
Accidents, misses and lies are printed; the exit status is 1 where there are any.
"""

from __future__ import annotations

import argparse
import contextlib
import io
import random
import re
import warnings
from collections import Counter
from collections.abc import Iterable, Iterator
from functools import cache
from importlib import import_module
from pathlib import Path
from typing import Any

from rospkg_cli.edits.format_manifest import format_text
from rospkg_cli.finding import Finding, Severity
from rospkg_cli.package.manifest import Manifest, manifest_of
from rospkg_cli.package.schema.schema import accepts
from rospkg_cli.source import Source
from rospkg_cli.testing import lint_files
from rospkg_cli.unreadable import UnreadableError

from .break_manifest import break_manifest
from .manifests import manifests

CODES = [f"XML{n}" for n in (1, 2, 3, 4, 101, 103, 104, 105, 106, 108, 201, 202, 203, 204, 205, 207, 210, 303)]
CODES = [f"XML{code[3:].zfill(3)}" for code in CODES] + ["RPK001"]
"""The rules that look at the text of package.xml alone, without pedantic ones."""

VARIABLES = {"ROS_VERSION": "2", "ROS_DISTRO": "jazzy", "ROS_PYTHON_VERSION": "3", "DISABLE_GROUPS_WORKAROUND": "1"}


class Official:
    """The schemas of the repository ros-infrastructure/rep."""

    def __init__(self, folder: Path) -> None:
        self.folder, self.etree = folder, import_module("lxml.etree")

    @cache  # noqa: B019 - lives as long as the program
    def schema(self, format: int) -> Any:
        return self.etree.XMLSchema(self.etree.parse(str(self.folder / f"package_format{format}.xsd")))

    def accepts(self, text: str, format: int) -> bool:
        parser = self.etree.XMLParser(encoding="utf-8")
        return bool(self.schema(format).validate(self.etree.fromstring(text.encode(), parser)))


def catkin_refuses(text: str) -> str:
    """Return why catkin_pkg refuses a text, as colcon calls it; "" where it does not."""
    package = import_module("catkin_pkg.package")
    try:
        found = package.parse_package_string(text, warnings=[])
        found.evaluate_conditions(VARIABLES)
        found.get_build_type()
    except Exception as error:  # colcon catches no more than these, and ends with a traceback or without the package
        return f"{type(error).__name__}: {error}".replace("\n", " ")
    return ""


def reasons(manifest: Manifest, ours: bool) -> Iterator[str]:
    """Yield why our schema and the official one may differ on a manifest, by what stands in it."""
    if ours:
        version = manifest.first("version")
        if manifest.schema_format == 3 and version is not None and version.get("compatibility"):
            yield "a compatibility: the official schema of format 3 declares its type and uses another"
        groups = manifest.all("group_depend", "member_of_group")
        if any(quote in (e.get("condition") or "") for e in groups for quote in "\"'"):
            yield "a quoted value in the condition of a group, which REP-149 allows"
        quoted = [q for a in manifest.conditions for q in re.findall(r"\"[^\"]*\"|'[^']*'", a.value)]
        if any(re.search(r"[^$A-Za-z0-9_\s<>!=()\"'-]", each) for each in quoted):
            yield "characters in a quoted value of a condition, which REP-149 allows"
        return
    if not re.fullmatch(r"\d+\.\d+\.\d+", manifest.version):
        yield "a version without dots: the official pattern takes any character for one"
    if re.search(r"version_\w+=\"[^\"]*[^0-9.\"]", manifest.source.text):
        yield "a version limit without dots: the official pattern takes any character for one"
    if any(not e.text for e in manifest.all("license")):
        yield "an empty license, which catkin_pkg refuses"
    if any(
        not re.fullmatch(r"[a-z][a-z0-9]*(_[a-z0-9]+)*", e.text)
        for e in manifest.all("group_depend", "member_of_group")
    ):
        yield "the name of a group, for which REP-149 wants the rules of package names"
    compatible = manifest.first("version")
    if compatible is not None and not re.fullmatch(r"\d+\.\d+\.\d+|", compatible.get("compatibility") or ""):
        yield "a compatibility that is not MAJOR.MINOR.PATCH, which REP-149 and catkin_pkg want"


def untrue(finding: Finding, refused: bool, schema_refuses: bool) -> bool:
    """Return whether a finding claims a refusal that does not happen."""
    says = finding.message
    if ("colcon refuses" in says or "colcon does not stop" in says or "colcon can't read" in says) and not refused:
        return True
    return re.search(r"ament_xmllint fails|where ament_xmllint is run", says) is not None and not schema_refuses


class Tally:
    def __init__(self, official: Official) -> None:
        self.official = official
        self.counts: Counter[str] = Counter()
        self.bad: list[str] = []

    def look(self, label: str, text: str) -> None:
        findings = lint_files({"package.xml": text}, CODES).findings
        refused = catkin_refuses(text)
        self.counts["texts"] += 1
        try:
            manifest = manifest_of(Source("package.xml", text))
        except UnreadableError as error:
            self.counts["not readable: by us and catkin_pkg" if refused else "not readable: by us alone"] += 1
            if not refused and "DOCTYPE" not in error.unreadable.message:
                self.bad.append(f"{label}: catkin_pkg reads it: {error.unreadable.message}")
            return
        format = manifest.schema_format
        theirs, ours = self.official.accepts(text, format), accepts(text, format)
        self.counts[
            f"schema: {'both accept' if theirs and ours else 'both refuse' if not (theirs or ours) else 'differ'}"
        ] += 1
        explained = theirs != ours and any(reasons(manifest, ours))
        if theirs != ours:
            found = list(reasons(manifest, ours))
            self.counts["  " + (found[0] if found else "accident")] += 1
            if not found:
                self.bad.append(f"{label}: the schemas differ (ours {ours}, official {theirs})")
        verdict = (
            f"catkin_pkg {'refuses' if refused else 'accepts'}, official schema {'accepts' if theirs else 'refuses'}"
        )
        self.counts[verdict] += 1
        if not refused and not theirs:
            alone = self.official.accepts(format_text(text), format)
            told = "the order alone" if alone else "more than the order"
            self.counts[f"catkin_pkg accepts, official schema refuses: {told}"] += 1
        if (refused or (not theirs and not explained)) and not findings:
            self.bad.append(f"{label}: a miss: catkin_pkg: {refused or 'fine'}; official schema: {theirs}")
        if refused and not any(f.severity is not Severity.INFO for f in findings):
            self.bad.append(f"{label}: only mildly told: {refused}")
        for finding in findings:
            if untrue(finding, bool(refused), not theirs):
                self.bad.append(f"{label}: a lie: {finding.code} {finding.message} | catkin_pkg: {refused or 'fine'}")


def repositories(paths: Iterable[str], folders: Iterable[Path]) -> set[str]:
    """Return the folders right below the given ones that hold a manifest."""
    return {
        Path(path).relative_to(folder).parts[0]
        for folder in folders
        for path in paths
        if Path(path).is_relative_to(folder)
    }


def main() -> int:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("folders", nargs="+", type=Path)
    parser.add_argument("--xsd", type=Path, required=True, help="the official schemas")
    parser.add_argument("--mutations", type=int, default=2000)
    parser.add_argument("--seed", type=int, default=1)
    arguments = parser.parse_args()
    warnings.simplefilter("ignore")
    official, chance = Official(arguments.xsd), random.Random(arguments.seed)
    real: dict[str, str] = {}
    for path in manifests(arguments.folders):
        with contextlib.suppress(UnicodeError):
            real[str(path)] = path.read_text("utf-8")
    asked = {f"real, of {len(repositories(real, arguments.folders))} repositories": real}
    names = sorted(real)
    broken = {}
    for index in range(arguments.mutations):
        name = names[index % len(names)]
        broken[f"{name} (broken copy {index})"] = break_manifest(real[name], chance, chance.choice([1, 1, 2, 3]))
    asked["broken copies"] = broken
    bad: list[str] = []
    for title, texts in asked.items():
        tally = Tally(official)
        for label, text in texts.items():
            with contextlib.redirect_stderr(io.StringIO()):
                tally.look(label, text)
        print(f"== {len(texts)} manifests, {title}")
        for what, count in sorted(tally.counts.items()):
            print(f"{count:6}  {what}")
        bad += tally.bad
    print(f"== {len(bad)} accidents, misses and lies", *bad[:60], sep="\n")
    return 1 if bad else 0


if __name__ == "__main__":
    raise SystemExit(main())
