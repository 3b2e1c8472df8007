"""Files of share directories that code names (DEP113): in C++, folders, and data that is read."""

from __future__ import annotations

import pytest

from rospkg_cli.example import CMAKE, SETUP_PY, manifest
from rospkg_cli.testing import lint_files

LOOKUP = 'ament_index_cpp::get_package_share_directory("my_pkg")'
HERE = {"data/x.csv": "1,2\n", "names/a.txt": "Ada\n"}
NAMES = "install(DIRECTORY names DESTINATION share/${PROJECT_NAME})\n"


def told(files: dict[str, str]) -> list[str]:
    return [each.message.split("`")[1] for each in lint_files({**HERE, **files}, ["DEP113"]).findings]


def in_cpp(*lines: str) -> list[str]:
    return told(
        {
            "CMakeLists.txt": CMAKE.replace(
                "ament_package()", f"add_executable(node src/node.cpp)\n{NAMES}ament_package()"
            ),
            "package.xml": manifest(build_type="ament_cmake"),
            "src/node.cpp": "".join(f"{line}\n" for line in lines),
        }
    )


@pytest.mark.parametrize(
    "lines",
    [
        (f'std::ifstream in({LOOKUP} + "/data/x.csv");',),
        (f"const auto share = {LOOKUP};", 'load(share + "/data/x.csv");'),
        ('auto share = get_package_share_path("my_pkg");', 'load(share / "data/x.csv");'),
    ],
)
def test_cpp_names_a_file_that_is_not_installed(lines: tuple[str, ...]) -> None:
    assert in_cpp(*lines) == ["data/x.csv"]


@pytest.mark.parametrize(
    "lines",
    [
        (f'load({LOOKUP} + "/data/" + name);',),
        ('auto share = get_package_share_path("my_pkg");', 'load(share / "data" / name);'),
        (f"std::string share = {LOOKUP};", 'load(share + std::string("/data/") + name + ".csv");'),
    ],
)
def test_cpp_looks_into_a_folder_that_is_not_installed(lines: tuple[str, ...]) -> None:
    assert in_cpp(*lines) == ["data"]


@pytest.mark.parametrize(
    "lines",
    [
        (f'load({LOOKUP} + "/names/a.txt");',),
        (f'std::string command = {LOOKUP} + "/names/a.txt ";',),
        (f'load({LOOKUP} + "/names/" + name);',),
        (f'load({LOOKUP} + "/data" + name);',),
        (f'load({LOOKUP} + "/nobodys/" + name);',),
        (f'std::ofstream out({LOOKUP} + "/data/" + name);',),
        (f'// load({LOOKUP} + "/data/x.csv");',),
        (f"auto share = {LOOKUP};", 'share = "/tmp";', 'load(share + "/data/x.csv");'),
        (f'if (std::filesystem::exists({LOOKUP} + "/data/x.csv")) load();',),
        (f'std::ofstream out({LOOKUP} + "/data/x.csv");',),
        ('load(get_package_prefix("my_pkg") + "/data/x.csv");',),
        ('load(get_package_share_directory("nobodys") + "/data/x.csv");',),
        ('load(get_package_share_directory(name) + "/data/x.csv");',),
    ],
)
def test_cpp_that_may_find_or_write_it(lines: tuple[str, ...]) -> None:
    assert in_cpp(*lines) == []


def test_cpp_names_a_near_file() -> None:
    assert in_cpp(f'load({LOOKUP} + "/names/a.tx");') == ["my_pkg"]


@pytest.mark.parametrize(
    "line, wanted",
    [
        ("os.listdir(os.path.join(SHARE, 'data'))", ["data"]),
        ("open(os.path.join(SHARE, 'data', 'x.csv'))", ["data/x.csv"]),
        ("frame.to_csv(os.path.join(SHARE, 'data', 'x.csv'))", []),
        ("os.listdir(os.path.join(SHARE, 'nothing'))", []),
        ("os.makedirs(os.path.join(SHARE, 'data'))", []),
        ("os.listdir(os.path.join(SHARE, '..', 'data'))", []),
    ],
)
def test_python_names_folders_and_data(line: str, wanted: list[str]) -> None:
    head = "import os\nfrom ament_index_python import get_package_share_directory\n"
    text = f"{head}SHARE = get_package_share_directory('my_pkg')\n{line}\n"
    marker = {"resource/my_pkg": "", "my_pkg/__init__.py": "", "setup.cfg": "", "setup.py": SETUP_PY}
    assert told({**marker, "package.xml": manifest(), "my_pkg/talker.py": text}) == wanted
