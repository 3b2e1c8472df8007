"""Interfaces of a package that a list of repositories fetches: of another version than the released one."""

from __future__ import annotations

import pytest

from rospkg_cli.engine.run.scope import Scope
from rospkg_cli.engine.run.session import Session
from rospkg_cli.example import BACKDROPS, existing_files
from rospkg_cli.rules.interfaces import idl010_unknown_field as idl010
from rospkg_cli.rules.interfaces import idl011_unknown_interface_import as idl011
from rospkg_cli.rules.interfaces import idl012_unknown_interface_in_cpp as idl012
from rospkg_cli.rules.interfaces import idl013_unknown_field_in_cpp as idl013
from rospkg_cli.tree import MemoryTree

BAD = {
    "IDL010": {
        "setup.py": idl010.TALKS,
        "package.xml": idl010.manifest(idl010.DEPENDS),
        "my_pkg/talker.py": idl010.TALKER.format("datta"),
    },
    "IDL011": {
        **BACKDROPS["ament_python"],
        **idl011.NEEDS_STD_MSGS,
        "my_pkg/talker.py": idl011.GOOD.replace("String", "Sting"),
    },
    "IDL012": {**idl012.FILES, "src/talker.cpp": idl012.SOURCE.replace("::String", "::Strng")},
    "IDL013": {**idl013.FILES, "src/talker.cpp": idl013.VALUE.replace("text.data", "text.daat")},
}


@pytest.mark.parametrize("code", BAD)
@pytest.mark.parametrize("listed, count", [((), 1), (("common",), 1), (("ours/std_msgs",), 0)])
def test_nothing_is_known_of_what_is_to_be_fetched(code: str, listed: tuple[str, ...], count: int) -> None:
    scope = Scope(("",), frozenset({""}), "my_pkg", "packages are missing", missing_repositories=frozenset(listed))
    files = existing_files(BAD[code])
    found = Session(MemoryTree.of(files), scope, frozenset({code})).run().findings
    assert len(found) == count
