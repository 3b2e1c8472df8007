"""The pages as a site, without building it: navigation, links, and the rule that a guide writes."""

from __future__ import annotations

import re
import subprocess
import sys
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import yaml
from typed_pages import typed
from writing import Write

from rospkg_cli.rule_address import PAGES

ROOT = Path(__file__).parents[1]
DOCS = ROOT / "docs"


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
    for path in (ROOT / SITE["theme"]["custom_dir"]).rglob("*.*"):
        assert "//" not in re.sub(r"(?m)^\s*//.*", "", path.read_text("utf-8")), path


def test_an_address_of_the_site_stands_everywhere_or_nowhere() -> None:
    """`[project.urls]` in pyproject.toml, `site_url` and where rules say that their pages stand."""
    project = (ROOT / "pyproject.toml").read_text("utf-8")
    urls = re.search(r"(?ms)^\[project\.urls\]$.*?^Documentation = \"(.*?)\"", project)
    site = urls[1].rstrip("/") if urls else None
    assert SITE.get("site_url", "").rstrip("/") == (site or "")
    assert (f"{site}/rules/{{code}}/" if site else "docs/rules/{code}.md") == PAGES


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
    lines = [each.line for each in typed("docs/writing-a-rule.md") if each.line.startswith("rospkg ")]
    program = f"import sys; sys.path.insert(0, {str(site)!r}); from rospkg_cli.cli.app import status\n"
    program += f"for line in {lines}: sys.argv = line.split(); print(status(), line, flush=True)"
    done = subprocess.run(
        [sys.executable, "-c", program], cwd=tmp_path / "ws", capture_output=True, text=True, timeout=60
    )
    assert (done.returncode, done.stderr) == (0, "")
    assert re.findall(r"^\d rospkg .*", done.stdout, re.MULTILINE) == [
        f"{int('lint' in each)} {each}" for each in lines
    ]
    assert "warning OUR001 maintainer-of-the-house" in done.stdout
    assert "no maintainer is of our house" in done.stdout
