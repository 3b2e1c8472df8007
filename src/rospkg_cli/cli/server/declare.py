"""The action that declares a dependency where a rule reports one and has no fix."""

from __future__ import annotations

from collections.abc import Iterator

from ...edits.manifest import add_dependency
from ...files import PackageFiles
from ...finding import Edit, Finding, Fix, Safety
from ...lazy_regex import regex
from ...light_dataclasses import replace
from ...package.manifest import Manifest
from ...package.package import Package
from ...ros.manifest import DEPENDENCY_TAGS
from ...ros.names import NameKind
from .linted import Linted
from .text_overlay import package_of

TELLING = ("DEP101", "DEP102", "DEP103", "DEP104", "DEP105", "DEP106", "DEP108", "DEP111")
"""The rules about what is used and not declared."""

TAGS = {"DEP102": "test_depend", "DEP103": "exec_depend", "DEP106": "exec_depend"}
"""Of the rules that do not name one in their message; that of the others is depend."""

NAME = regex(r"`([\w.+-]+)`")
TAG = regex(rf"<({'|'.join(DEPENDENCY_TAGS)})>")


def declarations(linted: Linted, finding: Finding) -> Iterator[Fix]:
    """Yield how to declare the packages that a finding names, those that exist and that package.xml does not have."""
    if finding.code not in TELLING or finding.fix:
        return
    folder = package_of(linted.root / finding.location.path, linted.root, linted.session.scope.folders)
    if folder is None:
        return
    manifest = Package(PackageFiles(linted.session.tree.sub(folder), folder)).parts(Manifest).only
    if manifest is None:
        return
    named = TAG.search(finding.message)
    tag = named.group(1) if named else TAGS.get(finding.code, "depend")
    declared = {each.name for each in manifest.dependencies} | {finding.package}
    for name in dict.fromkeys(NAME.findall(finding.message)):
        if name not in declared and is_known(linted, name):
            edit = add_dependency(manifest, tag, name)
            whole = f"{folder}/{edit.path}" if folder else edit.path
            operation: Edit = replace(edit, path=whole)
            yield Fix(f"declare `{name}` as <{tag}>", (operation,), Safety.UNSAFE)


def is_known(linted: Linted, name: str) -> bool:
    """Return whether a package of the workspace has a name, or one that can be installed."""
    of_workspace = name in {each.name for each in linted.run.scene.facts.values()}
    return of_workspace or linted.session.scope.index.kind_of(name) in (NameKind.PACKAGE, NameKind.KEY)
