"""A fault that ends a run is an error where a program comes to it at every start, and milder where only some do."""

from __future__ import annotations

import pytest

from rospkg_cli.example import BACKDROPS, existing_files, manifest, scripts, setup_py
from rospkg_cli.testing import lint_files

PACKAGE = {
    **existing_files(BACKDROPS["ament_python"]),
    "package.xml": manifest(
        "".join(f"  <exec_depend>{each}</exec_depend>\n" for each in ("ament_index_python", "std_msgs"))
    ),
    "setup.py": setup_py(scripts("talker = my_pkg.talker:main")),
}
FAULTS = {
    "DEP109": "from my_pkg.gone import a",
    "DEP112": "import ament_index_python.packages as index; index.get_package_share_directory('my_pgk')",
    "IDL011": "from std_msgs.msg import Sting",
}
WAYS = {
    "from my_pkg import way\n\n\ndef main(): ...\n": "error",
    "def main():\n    if input():\n        import my_pkg.way\n": "warning",
    "def main():\n    if input():\n        if input():\n            import my_pkg.way\n": "info",
}
TEST = "from my_pkg.way import go\n\n\ndef test_it():\n    go()\n"


def levels(code: str, **files: str) -> list[str]:
    more = {path.replace("__", "/") + ".py": text for path, text in files.items()}
    return [each.severity.value for each in lint_files({**PACKAGE, **more}, [code]).findings]


@pytest.mark.parametrize("code", FAULTS)
@pytest.mark.parametrize("talker", WAYS)
def test_a_module_is_imported_under_conditions(code: str, talker: str) -> None:
    assert levels(code, my_pkg__talker=talker, my_pkg__way=f"{FAULTS[code]}\n") == [WAYS[talker]]


@pytest.mark.parametrize("code", FAULTS)
def test_only_tests_come_to_it(code: str) -> None:
    way = f"{FAULTS[code]}\n\n\ndef go(): ...\n"
    assert levels(code, my_pkg__talker="def main(): ...\n", my_pkg__way=way, test__test_it=TEST) == ["warning"]
    assert levels(code, my_pkg__talker="from my_pkg import way\n\n\ndef main(): ...\n", my_pkg__way=way) == ["error"]
    itself = f"{FAULTS[code]}\n\n\ndef test_it(): ...\n"
    assert levels(code, my_pkg__talker="def main(): ...\n", test__test_it=itself) == ["warning"]


@pytest.mark.parametrize("code", FAULTS)
def test_a_page_alone_names_the_module(code: str) -> None:
    files = {
        "my_pkg/talker.py": "def main(): ...\n",
        "my_pkg/way.py": f"{FAULTS[code]}\n",
        "README.md": "See `way.py`.\n",
    }
    assert [each.severity.value for each in lint_files({**PACKAGE, **files}, [code]).findings] == ["info"]
    files["README.md"] = "Type `python3 my_pkg/way.py`.\n"
    assert [each.severity.value for each in lint_files({**PACKAGE, **files}, [code]).findings] != ["info"]
    plugin = "<library path='my_pkg'><class type='my_pkg.way.Way'/></library>\n"
    files["plugin.xml"] = plugin.replace("'", '"')
    assert [each.severity.value for each in lint_files({**PACKAGE, **files}, [code]).findings] == ["error"]


@pytest.mark.parametrize(("call", "level"), [("look()", "error"), ("if input():\n        look()", "warning")])
def test_a_function_is_called_under_a_condition(call: str, level: str) -> None:
    talker = f"def look():\n    {FAULTS['DEP112']}\n\n\ndef main():\n    {call}\n"
    assert levels("DEP112", my_pkg__talker=talker) == [level]
