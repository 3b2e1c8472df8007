"""DEP118: a path in a home is an info where code only takes it once a look-up of the right place has failed."""

from __future__ import annotations

import pytest

from rospkg_cli.example import BACKDROPS, CMAKE, existing_files, manifest, scripts, setup_py
from rospkg_cli.testing import lint_files

PYTHON = {
    **existing_files(BACKDROPS["ament_python"]),
    "data/a.txt": "Ada\n",
    "setup.py": setup_py(scripts("talker = my_pkg.talker:main")),
}
PLACE = "/home/ada/ws/src/my_pkg/data/a.txt"
CPP = {
    "package.xml": manifest("", "ament_cmake"),
    "data/a.txt": "Ada\n",
    "CMakeLists.txt": CMAKE.replace(
        "ament_package",
        "add_executable(talker src/talker.cpp)\ninstall(TARGETS talker DESTINATION lib/my_pkg)\nament_package",
    ),
}
LAST = "; it is tried only where something else failed before"


def told(files: dict[str, str], path: str, text: str) -> tuple[str, bool]:
    """Return the level, and whether the message ends with the reason."""
    (found,) = lint_files({**files, path: text}, ["DEP118"]).findings
    return found.severity.value, found.message.endswith(LAST)


@pytest.mark.parametrize(
    ("lines", "is_last"),
    [
        ('try { load(share() + "/a.txt"); } catch (const std::exception & e) { load("{}"); }', True),
        ('try { load(share()); } catch (...) { if (on) { warn("{"); load("{}"); } }', True),
        ('try { load("{}"); } catch (const std::exception & e) { warn(e); }', False),
        ('try { load(share()); } catch (...) { warn(); } load("{}");', False),
        ('load(find_share("my_pkg").value_or("{}"));', True),
        ('load(share.empty() ? "{}" : share + "/a.txt");', True),
        ('load(find_file().value_or("{}"));', False),
        ('load(std::make_shared<File>(on ? "{}" : ""));', False),
        ('share(); load("{}");', False),
    ],
)
def test_a_path_in_cpp(lines: str, is_last: bool) -> None:
    text = f"int main() {{\n  {lines.replace('{}', PLACE)}\n}}\n"
    assert told(CPP, "src/talker.cpp", text) == ("info" if is_last else "warning", is_last)


@pytest.mark.parametrize(
    ("lines", "is_last"),
    [
        ("a = find_share() or '{}'", True),
        ("a = share + '/a.txt' if share else '{}'", True),
        ("a = '{}' if share else share", False),
        ("a = os.environ.get('A') or '{}'", False),
        ("a = '{}' or find_share()", False),
        ("try:\n        a = find_share()\n    except LookupError:\n        a = '{}'", True),
    ],
)
def test_a_path_in_python(lines: str, is_last: bool) -> None:
    text = f"def main():\n    {lines.format(PLACE)}\n    print(open(a))\n"
    assert told(PYTHON, "my_pkg/talker.py", text) == ("info" if is_last else "warning", is_last)
