"""Keywords of CMake that stand twice: of single values the last one counts, of many all (tried with CMake 3.25)."""

from __future__ import annotations

import pytest
from cmaking import read, table

FILES = {"src/a.cpp": ""}


def installed(lines: str) -> set[str]:
    made = f"project(my_pkg)\nadd_executable(a src/a.cpp)\nadd_executable(b src/a.cpp)\n{lines}\n"
    return {each for each in table({**FILES, "CMakeLists.txt": made}) if each.startswith(("lib/", "bin/"))}


@pytest.mark.parametrize(
    ("lines", "names"),
    [
        ("set_target_properties(a PROPERTIES OUTPUT_NAME x OUTPUT_NAME y)", {"bin/y"}),
        ("set_target_properties(a PROPERTIES FOLDER OUTPUT_NAME)", {"bin/a"}),
        ("set_target_properties(a b PROPERTIES FOLDER tools OUTPUT_NAME x)", {"bin/x"}),
        ("set_property(TARGET a APPEND PROPERTY OUTPUT_NAME x)", {"bin/x"}),
        ("set_property(TARGET a PROPERTY FOLDER OUTPUT_NAME x)", {"bin/a"}),
    ],
)
def test_properties_are_read_in_pairs(lines: str, names: set[str]) -> None:
    assert installed(f"{lines}\ninstall(TARGETS a DESTINATION bin)") == names


@pytest.mark.parametrize(
    ("rule", "places"),
    [
        ("TARGETS a TARGETS b DESTINATION bin", {"bin/a", "bin/b"}),
        ("TARGETS a DESTINATION lib/my_pkg DESTINATION bin", {"bin/a"}),
        ("TARGETS a RUNTIME DESTINATION lib/my_pkg RUNTIME DESTINATION bin", {"bin/a"}),
        ("PROGRAMS src/a.cpp DESTINATION lib/my_pkg DESTINATION bin", {"bin/a.cpp"}),
        ("PROGRAMS src/a.cpp DESTINATION bin b", {"bin/a.cpp"}),
    ],
)
def test_the_last_destination_counts(rule: str, places: set[str]) -> None:
    assert installed(f"install({rule})") == places


def test_of_single_values_the_last_one_counts() -> None:
    parsed = 'cmake_parse_arguments(A F S M S a S b M x M y F z)\nproject("${A_S}_${A_M}_${A_UNPARSED_ARGUMENTS}")\n'
    assert read(parsed).project_name == "b_x;y_z"
