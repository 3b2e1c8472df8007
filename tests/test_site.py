"""The pages as a site, without building it: navigation, links, and the commands of the guides, each typed in turn."""

from __future__ import annotations

import re
import subprocess
import sys
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import pytest
import yaml
from in_process import run_here
from writing import Write

ROOT = Path(__file__).parents[1]
DOCS = ROOT / "docs"
GUIDES = ("docs/first-package.md", "docs/adopting.md", "docs/lyrical.md", "README.md")
TYPED_IN_README = "## In ten lines"
OLD_SETUP = """\
from setuptools import setup

setup(
    name='my_pkg', version='0.1.0', packages=['my_pkg'], tests_require=['pytest'],
    data_files=[('share/ament_index/resource_index/packages', ['resource/my_pkg']), ('share/my_pkg', ['package.xml'])],
)
"""


class Settings(yaml.SafeLoader):
    """Reads mkdocs.yml, whose tags name functions of Python."""


Settings.add_multi_constructor("tag:yaml.org,2002:python/", lambda loader, suffix, node: suffix)
SITE: dict[str, Any] = yaml.load((ROOT / "mkdocs.yml").read_text("utf-8"), Settings)


def pages(entries: list[Any]) -> Iterator[str]:
    """Yield the pages of a navigation."""
    for entry in entries:
        for value in entry.values():
            yield from [value] if isinstance(value, str) else pages(value)


def test_every_page_is_in_the_navigation() -> None:
    there = {path.relative_to(DOCS).as_posix() for path in DOCS.glob("*.md")} | {"rules/README.md"}
    assert sorted(pages(SITE["nav"])) == sorted(there), "name each page below `nav` in mkdocs.yml"


def test_pages_lead_only_to_the_site_and_the_web() -> None:
    for page in DOCS.rglob("*.md"):
        text = re.sub(r"^```.*?^```|`[^`\n]*`", "", page.read_text("utf-8"), flags=re.MULTILINE | re.DOTALL)
        for link in re.findall(r"\]\(([^)\s]+)\)", text):
            if not re.match(r"[a-z]+:|#", link):
                assert (page.parent / link.partition("#")[0]).resolve().is_relative_to(DOCS), f"{page}: {link}"


def test_nothing_of_the_site_comes_from_elsewhere() -> None:
    assert SITE["theme"]["font"] is False
    assert not {"extra_css", "extra_javascript"} & set(SITE)


def commands(guide: str) -> list[str]:
    """Return the commands of rospkg in the blocks of a guide, without what explains them."""
    text = (ROOT / guide).read_text("utf-8")
    if guide == "README.md":
        text = text.partition(TYPED_IN_README)[2].partition("\n## ")[0]
    return [re.split(r" {2,}| > ", line)[0] for line in re.findall(r"^    (rospkg .*)$", text, re.MULTILINE)]


def words(command: str) -> list[str]:
    """Return the words of a command line, without the quotes of a shell."""
    return [re.sub(r'"', "", word) for word in re.findall(r'(?:"[^"]*"|\S)+', command)][1:]


@pytest.mark.parametrize("guide", GUIDES)
def test_the_commands_of_a_guide_do_what_they_say(
    guide: str, tmp_path: Path, write: Write, clean: dict[str, str], monkeypatch: pytest.MonkeyPatch
) -> None:
    (tmp_path / "gitconfig").write_text("[user]\n\tname = Ada Lovelace\n\temail = ada@example.org\n")
    monkeypatch.setenv("GIT_CONFIG_GLOBAL", str(tmp_path / "gitconfig"))
    if guide != "docs/first-package.md":
        write(tmp_path / "src/my_pkg", {**clean, "setup.py": OLD_SETUP})
        for command in ("init -q", "add src", "commit -q -m old"):
            subprocess.run(["git", *command.split()], cwd=tmp_path, check=True, timeout=60)
    typed = commands(guide)
    assert len(typed) > 2
    for command in typed:
        done = run_here(*words(command), cwd=tmp_path, ROS_DISTRO="jazzy")
        assert done.returncode in (0, 1), f"{command}\n{done.stdout}{done.stderr}"
        if guide == "docs/first-package.md" or "--exit-zero" in command or "baseline" in command:
            assert done.returncode == 0, f"{command}\n{done.stdout}{done.stderr}"


def test_the_rule_of_the_guide_is_found_and_told(tmp_path: Path, write: Write, clean: dict[str, str]) -> None:
    rule, _ = re.findall(r"```python\n(.*?)```", (DOCS / "writing-a-rule.md").read_text("utf-8"), re.DOTALL)
    project, config = re.findall(r"```toml\n(.*?)```", (DOCS / "writing-a-rule.md").read_text("utf-8"), re.DOTALL)
    name, module = re.findall(r'^([\w-]+) = "(\w+)"$', project.partition("entry-points")[2], re.MULTILINE)[0]
    site = tmp_path / "site"
    write(
        site,
        {
            f"{module}.py": rule,
            "our_house-1.0.dist-info/METADATA": "Metadata-Version: 2.1\nName: our-house\nVersion: 1.0\n",
            "our_house-1.0.dist-info/entry_points.txt": f"[rospkg_cli.rules]\n{name} = {module}\n",
        },
    )
    write(tmp_path / "ws", {"rospkg.toml": config, **{f"my_pkg/{path}": text for path, text in clean.items()}})
    (command,) = [each for each in commands("docs/writing-a-rule.md") if each.startswith("rospkg lint")]
    program = f"import sys; sys.path.insert(0, {str(site)!r}); from rospkg_cli.__main__ import main; sys.exit(main())"
    typed = [sys.executable, "-c", program, *words(command), "--format", "concise"]
    done = subprocess.run(typed, cwd=tmp_path / "ws", capture_output=True, text=True, timeout=60, check=False)
    assert done.returncode == 1, done.stderr
    assert "warning OUR001 maintainer-of-the-house: no maintainer is of our house" in done.stdout
