"""`rospkg upgrade`: what a newer distribution removed is fixed, and what is left is said."""

from __future__ import annotations

import subprocess
from pathlib import Path

import pytest
from in_process import run_here
from writing import Write

from rospkg_cli.example import manifest

CMAKE = """\
cmake_minimum_required(VERSION 3.5)
project(my_pkg)
find_package(ament_cmake REQUIRED)
find_package(rclcpp REQUIRED)
add_executable(driver src/driver.cpp)
ament_target_dependencies(driver rclcpp)
install(TARGETS driver DESTINATION lib/${PROJECT_NAME})
ament_package()
"""
FILES = {
    "package.xml": manifest("  <depend>rclcpp</depend>\n", "ament_cmake"),
    "CMakeLists.txt": CMAKE,
    "src/driver.cpp": "#include <rclcpp/rclcpp.hpp>\nint main() { return 0; }\n",
}
AFTER = CMAKE.replace("VERSION 3.5", "VERSION 3.10").replace(
    "ament_target_dependencies(driver rclcpp)", "target_link_libraries(driver PUBLIC rclcpp::rclcpp)"
)


@pytest.fixture
def package(tmp_path: Path, write: Write) -> Path:
    return write(tmp_path / "ws/my_pkg", FILES)


def test_it_shows_first(package: Path) -> None:
    done = run_here("upgrade", "--to", "lyrical", cwd=package)
    assert done.returncode == 1
    assert "-ament_target_dependencies(driver rclcpp)" in done.stdout
    assert done.stderr.splitlines() == [
        "rospkg: lyrical: 2 of 2 findings would be fixed, in 1 file (CMK002 1, CMK005 1)",
        "rospkg: nothing was written; --write writes it",
    ]
    assert (package / "CMakeLists.txt").read_text() == CMAKE


def test_it_writes_and_is_done(package: Path) -> None:
    done = run_here("upgrade", "--to", "lyrical", "--write", "--allow-dirty", cwd=package)
    assert (done.returncode, done.stdout) == (0, "")
    assert done.stderr == "rospkg: lyrical: 2 of 2 findings fixed, in 1 file (CMK002 1, CMK005 1)\n"
    assert "ament_target_dependencies" not in (package / "CMakeLists.txt").read_text()
    again = run_here("upgrade", "--to", "lyrical", cwd=package)
    assert (again.returncode, again.stderr) == (0, "rospkg: nothing here is wrong for lyrical that was right before\n")


def test_what_is_wrong_for_old_distributions_too_stays(package: Path) -> None:
    path = package / "CMakeLists.txt"
    path.write_text(CMAKE.replace("install(TARGETS driver DESTINATION lib/${PROJECT_NAME})\n", ""))
    done = run_here("upgrade", "--to", "lyrical", "--write", "--allow-dirty", cwd=package)
    assert done.returncode == 0
    assert "install(" not in path.read_text()


def test_what_is_left_is_named_with_its_place(package: Path) -> None:
    text = CMAKE.replace("driver rclcpp)", "driver rclcpp ${MORE})")
    (package / "CMakeLists.txt").write_text(text)
    done = run_here("upgrade", "--to", "lyrical", cwd=package)
    lines = done.stderr.splitlines()
    assert done.returncode == 1
    assert "rospkg: left to do by hand: 1" in lines
    assert any(line.startswith("rospkg:   CMakeLists.txt:6: CMK005 ") for line in lines)


def test_git_must_be_able_to_bring_it_back(package: Path) -> None:
    done = run_here("upgrade", "--to", "lyrical", "--write", cwd=package)
    assert done.returncode == 2
    assert "is in no git repository, so nothing could bring the old files back" in done.stderr
    git = ["git", "-c", "user.name=Ada", "-c", "user.email=ada@example.org"]
    subprocess.run(["git", "init", "-q"], cwd=package, check=True)
    subprocess.run(["git", "add", "-A"], cwd=package, check=True)
    subprocess.run([*git, "commit", "-qm", "A commit"], cwd=package, check=True)
    (package / "CMakeLists.txt").write_text(CMAKE + "# mine\n")
    refused = run_here("upgrade", "--to", "lyrical", "--write", cwd=package)
    assert (refused.returncode, "changes are not committed" in refused.stderr) == (2, True)
    subprocess.run([*git, "commit", "-qam", "Mine"], cwd=package, check=True)
    assert run_here("upgrade", "--to", "lyrical", "--write", cwd=package).returncode == 0


@pytest.mark.parametrize(
    "arguments, says",
    [
        ((), "name the distribution to move to: --to lyrical"),
        (("--to", "lyrcal"), "did you mean `lyrical`?"),
        (("--to", "humble"), "humble is the oldest distribution that is known here; there is nothing to move from"),
    ],
)
def test_wrong_use(package: Path, arguments: tuple[str, ...], says: str) -> None:
    done = run_here("upgrade", *arguments, cwd=package)
    assert (done.returncode, done.stdout) == (2, "")
    assert says in done.stderr


def test_without_a_package_it_says_so(tmp_path: Path) -> None:
    done = run_here("upgrade", "--to", "lyrical", cwd=tmp_path)
    assert (done.returncode, "there is no package at `.`" in done.stderr) == (2, True)
