"""What `new` writes as it was last looked at: every file, and what says what is built, installed and needed.

`pytest tests/test_new_trees.py --update-golden` writes them anew; read the diff before it is committed.
"""

from __future__ import annotations

from pathlib import Path

import pytest
from planned import plan, texts

from rospkg_cli.scaffold.extras import all_extras
from rospkg_cli.scaffold.plan import Plan
from rospkg_cli.scaffold.template import load_template, template_names
from rospkg_cli.scaffold.test_level import TEST_LEVELS

TREES = Path(__file__).parent / "trees"
GENERATING = [name for name in template_names() if load_template(name).generates]
SHOWN = ("package.xml", "setup.py", "CMakeLists.txt")
"""The files whose text is kept."""


def shown(planned: Plan) -> str:
    """Return the paths of all files, and the text of those that say what is built, installed and needed."""
    files = texts(planned)
    return "\n".join([*files, ""]) + "".join(f"\n── {path}\n{files[path]}" for path in SHOWN if path in files)


@pytest.mark.parametrize("tests", TEST_LEVELS)
@pytest.mark.parametrize("template", template_names())
def test_the_tree_is_the_one_that_was_looked_at(template: str, tests: str, pytestconfig: pytest.Config) -> None:
    launches = load_template(template).launches
    launch = {"ament": "py", "minimal": "xml", "none": "yaml"}[tests] if launches else ""
    extras = tuple(all_extras()) if tests == "ament" else ()
    planned = plan("my_robot", template=template, tests=tests, launch=launch, extras=extras, distro="jazzy")
    golden = TREES / f"{template}-{tests}.txt"
    if pytestconfig.getoption("--update-golden"):
        golden.write_text(shown(planned))
    assert shown(planned) == golden.read_text()


@pytest.mark.parametrize("template", GENERATING)
def test_so_is_the_one_with_generated_parameters(template: str, pytestconfig: pytest.Config) -> None:
    planned = plan("my_robot", template=template, tests="none", parameters="generate", distro="jazzy")
    definitions = {path: text for path, text in texts(planned).items() if path.endswith("_parameters.yaml")}
    text = shown(planned) + "".join(f"\n── {path}\n{text}" for path, text in definitions.items())
    golden = TREES / f"{template}-generate.txt"
    if pytestconfig.getoption("--update-golden"):
        golden.write_text(text)
    assert text == golden.read_text()


def test_no_tree_is_left_over() -> None:
    assert {path.stem for path in TREES.iterdir()} == {
        *(f"{name}-{tests}" for name in template_names() for tests in TEST_LEVELS),
        *(f"{name}-generate" for name in GENERATING),
    }
