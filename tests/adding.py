"""Adding to packages in memory, and what must hold of each addition."""

from __future__ import annotations

from rospkg_cli.addition.part import put_in, take_out
from rospkg_cli.addition.wanted import Wanted, parts_to_add, parts_to_remove
from rospkg_cli.change.draft import Draft, same
from rospkg_cli.example import manifest
from rospkg_cli.package.install_table import InstallTable
from rospkg_cli.scaffold.workspace import WorkspacePackages
from rospkg_cli.testing import lint_files
from rospkg_cli.tree import MemoryTree

THERE = WorkspacePackages()
PYTHON = manifest()
CMAKE = manifest("  <buildtool_depend>ament_cmake</buildtool_depend>\n", build_type="ament_cmake")
MAIN = "def main():\n    pass\n"


def python_package(setup: str, **more: str) -> dict[str, str]:
    """Return a package with one node `old`, by its setup.py."""
    return {
        "package.xml": PYTHON,
        "setup.py": setup,
        "setup.cfg": "[develop]\nscript_dir=$base/lib/my_pkg\n[install]\ninstall_scripts=$base/lib/my_pkg\n",
        "resource/my_pkg": "",
        "my_pkg/__init__.py": "",
        "my_pkg/old.py": MAIN,
        **{path.replace("__", "/"): text for path, text in more.items()},
    }


def cmake_package(cmake: str, **more: str) -> dict[str, str]:
    return {"package.xml": CMAKE, "CMakeLists.txt": cmake, "src/old.cpp": "int main() {return 0;}\n", **more}


def added(files: dict[str, str], what: str, *names: str, **options: object) -> Draft:
    """Add to a package in memory, and check what holds of each addition: insertions alone, and twice is once."""
    draft = Draft(MemoryTree.of(files))
    wanted = Wanted(what, names, **options)  # type: ignore[arg-type]
    put(draft, wanted)
    for path, text in files.items():
        entry = draft.entry(path)
        assert entry is not None
        after = iter(entry.data.decode())
        assert all(char in after for char in text), f"more than insertions in {path}"
    again = draft.copy()
    put(again, wanted)
    assert again.changes.keys() == draft.changes.keys()
    assert all(same(again.entry(path), draft.entry(path)) for path in again.changes)
    return draft


def put(draft: Draft, wanted: Wanted) -> None:
    for name in wanted.names:
        put_in(draft, "", parts_to_add(draft.package(""), wanted, name, THERE))


def taken(draft: Draft, what: str, *names: str, force: bool = False) -> tuple[Draft, bool]:
    """Remove from what a draft came to; return that, and whether it is the exact opposite of adding."""
    after, exact = Draft(draft.tree), True
    for name in names:
        parts = parts_to_remove(after.package(""), Wanted(what, names, force=force), name, THERE)
        exact &= take_out(after, "", parts)
    return after, exact


def text(draft: Draft, path: str) -> str:
    entry = draft.entry(path)
    assert entry is not None, f"there is no {path}"
    return entry.data.decode()


def executables(draft: Draft) -> set[str]:
    table = draft.package("").parts(InstallTable).only
    assert table is not None
    return {path for path, _ in table.below("lib/my_pkg")}


def shares(draft: Draft) -> set[str]:
    table = draft.package("").parts(InstallTable).only
    assert table is not None
    return {path for path, _ in table.below("share/my_pkg")}


def comes_back(files: dict[str, str], draft: Draft, what: str, *names: str) -> None:
    """Check that removing brings back every byte."""
    after, exact = taken(draft, what, *names)
    now = {path: entry.data.decode() for path in after.tree.files() if (entry := after.entry(path))}
    assert now == files
    assert exact


def new_findings(files: dict[str, str], draft: Draft) -> list[str]:
    """Return what all rules say after that they did not say before."""
    before = [f"{each.code} {each.message}" for each in lint_files(files).findings]
    entries = {path: draft.tree.entry(path) for path in draft.tree.files()}
    after = [f"{each.code} {each.message}" for each in lint_files(entries).findings]
    return [each for each in after if each not in before]
