"""One fault, one finding: the specific rule speaks, and what follows from it keeps quiet."""

from __future__ import annotations

from rospkg_cli.example import CMAKE, manifest
from rospkg_cli.testing import lint_files

ENTRY = "    entry_points={'console_scripts': ['talker = my_pkg.talker:main']},\n    license="


def with_launch(clean: dict[str, str]) -> dict[str, str]:
    return {
        **clean,
        "setup.py": clean["setup.py"].replace("    license=", ENTRY),
        "my_pkg/talker.py": "def main():\n    pass\n",
        "launch/a.launch.xml": '<launch>\n  <node pkg="my_pkg" exec="talker"/>\n</launch>\n',
    }


def codes(files: dict[str, str]) -> list[str]:
    return [f.code for f in lint_files(files).findings if f.code.startswith(("SET0", "SET1", "LCH002"))]


def test_an_executable_in_bin_is_no_unknown_one(clean) -> None:
    files = with_launch(clean)
    assert codes(files) == []
    assert codes({path: text for path, text in files.items() if path != "setup.cfg"}) == ["SET001"]
    moved = files["setup.cfg"].replace("install_scripts=$base/lib/my_pkg", "install_scripts=$base/lib/other")
    assert codes({**files, "setup.cfg": moved}) == ["SET002"]


def test_a_name_with_signs_in_it_is_the_same_name(clean) -> None:
    manifest = clean["package.xml"].replace(">Ada<", ">Ada &lt;L&gt; &amp; Co<")
    setup = clean["setup.py"].replace("maintainer='Ada'", "maintainer='Ada <L> & Co'")
    files = {**clean, "package.xml": manifest, "setup.py": setup}
    assert [f.message for f in lint_files(files, ["SET403"]).findings] == []
    other = {**files, "setup.py": setup.replace("& Co", "& Sons")}
    assert [f.code for f in lint_files(other, ["SET403"]).findings] == ["SET403"]


def test_ament_lint_common_stands_for_the_linters_of_cmake() -> None:
    test = "if(BUILD_TESTING)\n  find_package(ament_cmake_flake8 REQUIRED)\nendif()\nament_package()"
    files = {"CMakeLists.txt": CMAKE.replace("ament_package()", test)}

    def missing(depends: str) -> list[str]:
        tree = {**files, "package.xml": manifest(depends, "ament_cmake")}
        return [f.code for f in lint_files(tree, ["DEP104"]).findings]

    assert missing("") == ["DEP104"]
    assert missing("  <test_depend>ament_lint_common</test_depend>\n") == []


def test_an_executable_that_another_package_launches_must_stand_in_lib(clean) -> None:
    def level(launch: str) -> list[str]:
        setup = clean["setup.py"].replace("    license=", ENTRY.replace("talker", "convert"))
        own = {**clean, "setup.py": setup, "my_pkg/convert.py": "def main():\n    pass\n"}
        tree = {f"a/{path}": text for path, text in own.items() if path != "setup.cfg"}
        tree |= {"b/package.xml": manifest(name="bringup"), "b/launch/b.launch.xml": f"<launch>{launch}</launch>"}
        return [f.severity.value for f in lint_files(tree, ["SET001"]).findings]

    assert level("") == ["info"]
    assert level('<node pkg="my_pkg" exec="convert"/>') == ["error"]
