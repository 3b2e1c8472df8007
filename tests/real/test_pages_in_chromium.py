"""The HTML of `graph` and `lint` in a real browser: searched, clicked, filtered, alone, and readable for everybody."""

from __future__ import annotations

import io
from collections.abc import Iterator
from pathlib import Path

import pytest
from chromium import Browser, started_browser
from sample_findings import forty

from rospkg_cli.engine.run.results import Results
from rospkg_cli.graph.as_html import as_html
from rospkg_cli.graph.workspace_graph import GraphEdge, GraphNode, WorkspaceGraph
from rospkg_cli.light_dataclasses import replace
from rospkg_cli.report import Report, render

NASTY = '</script><img src="https://example.com/x">'
NAMES = ("base_pkg", "my_msgs", "my_pkg", "my_pkg/launch/all.launch.py", "other_pkg", NASTY)
EDGES = (
    GraphEdge("base_pkg", "my_pkg", ("test",), marks=("cycle",)),
    GraphEdge("my_pkg", "base_pkg", ("build", "exec"), marks=("cycle",)),
    GraphEdge("my_pkg", "my_msgs", ("exec", "interface"), marks=("undeclared",)),
    GraphEdge("my_pkg", "my_pkg/launch/all.launch.py", ("launch",)),
    GraphEdge("my_pkg/launch/all.launch.py", "base_pkg", ("launch",), "drive"),
    GraphEdge("other_pkg", NASTY, ("exec",), marks=("unused",)),
)


@pytest.fixture(scope="module")
def browser() -> Iterator[Browser]:
    with started_browser() as started:
        yield started


@pytest.fixture(scope="module")
def pages(tmp_path_factory: pytest.TempPathFactory) -> dict[str, Path]:
    folder = tmp_path_factory.mktemp("pages")
    nodes = tuple(GraphNode(n, n.partition("/launch")[0], n in ("my_msgs", NASTY)) for n in sorted(NAMES))
    (folder / "graph.html").write_text("\n".join(as_html(WorkspaceGraph(nodes, EDGES))), "utf-8")
    findings = [
        replace(each, edit_locations=(each.location,) * len(each.fix.operations) if each.fix else ())
        for each in forty().findings[::20]
    ]
    text = io.StringIO()
    render("html", Report(Results(tuple(findings)), Path("/ws"), Path("/ws")), text)
    (folder / "lint.html").write_text(text.getvalue(), "utf-8")
    return {path.stem: path for path in folder.iterdir()}


def test_the_graph_is_searched_clicked_and_filtered(browser: Browser, pages: dict[str, Path]) -> None:
    browser.open(pages["graph"])
    browser.shows("#count", "5 packages, 6 edges shown, 6 found")
    browser.find("#search").send_keys("MSGS")
    browser.shows("#count", "5 packages, 6 edges shown, 1 found")
    browser.find("#names button").click()
    browser.shows("#details h2", "my_msgs (not here)")
    browser.shows("#details li .dim", "exec, interface undeclared")
    browser.choose("#depth", "1 step")
    browser.shows("#count", "2 packages, 1 edges shown, 1 found")
    browser.find("button[type=reset]").click()
    browser.shows("#count", "5 packages, 6 edges shown, 6 found")
    browser.find("[value=exec]").click()
    browser.shows("#count", "4 packages, 5 edges shown, 5 found")
    browser.choose("#mark", "cycle")
    browser.shows("#count", "2 packages, 2 edges shown, 2 found")
    browser.choose("#mark", "all edges")
    browser.find("#launch").click()
    browser.find("#outside").click()
    browser.shows("#count", "3 packages, 2 edges shown, 3 found")


def test_a_node_of_the_picture_is_clicked(browser: Browser, pages: dict[str, Path]) -> None:
    browser.open(pages["graph"])
    at = browser.run(
        "const node = picture.nodes().filter((each) => each.data('label') === 'other_pkg').renderedPosition();"
        "const box = get('graph').getBoundingClientRect(); return [box.x + node.x, box.y + node.y].map(Math.round)"
    )
    from selenium.webdriver import ActionChains

    ActionChains(browser.driver).move_by_offset(*at).click().perform()
    browser.wait(lambda: browser.text("#details") != "")
    browser.shows("#details h2", "other_pkg")
    browser.shows("#details li button", NASTY)


def test_the_report_is_searched_and_filtered(browser: Browser, pages: dict[str, Path]) -> None:
    browser.open(pages["lint"])
    total = int(browser.text("#count").split()[2])
    browser.choose("#level", "error")
    errors = len(browser.driver.find_elements("css selector", "article[data-level=error]"))
    browser.shows("#count", f"{errors} of {total} shown")
    assert 0 < errors < total
    browser.find("#search").send_keys("no such words")
    browser.shows("#count", f"0 of {total} shown")
    browser.find("button[type=reset]").click()
    browser.shows("#count", f"{total} of {total} shown")


@pytest.mark.parametrize("page", ["graph", "lint"])
def test_a_page_loads_nothing_and_hinders_nobody(browser: Browser, pages: dict[str, Path], page: str) -> None:
    browser.open(pages[page])
    if page == "graph":
        browser.find("#names button").click()
    assert browser.requests() == []
    assert browser.complaints() == []
    for scheme in ("light", "dark"):
        browser.color_scheme(scheme)
        assert browser.hindrances() == [], scheme


def test_a_window_made_narrow_shows_the_whole_graph(browser: Browser, pages: dict[str, Path]) -> None:
    inside = """
    const box = picture.elements(":visible").renderedBoundingBox();
    return box.x1 >= 0 && box.x2 <= picture.width() && picture.width() < arguments[0];
    """
    before = browser.driver.get_window_size()
    browser.driver.set_window_size(1400, 900)
    try:
        browser.open(pages["graph"])
        assert browser.run(inside, 1400)
        browser.driver.set_window_size(420, 800)
        browser.wait(lambda: browser.run(inside, 500))
    finally:
        browser.driver.set_window_size(before["width"], before["height"])


def test_large_parts_and_cycles_have_a_place_for_each(browser: Browser, pages: dict[str, Path]) -> None:
    browser.open(pages["graph"])
    script = """
    const ids = [...Array(400).keys()].map(String);
    const edges = ids.flatMap((id, at) => [[id, ids[(at * 7 + 3) % 400]], [id, ids[at >> 1]]]);
    const sizes = [ids, ids.slice(0, 40)].map((some) => {
      const inside = edges.filter((edge) => edge.every((id) => some.includes(id)));
      const { places } = arrange(some, inside, () => 80);
      return new Set([...places.values()].filter(({ x, y }) => x + y > 0).map(({ x, y }) => `${x},${y}`)).size;
    });
    return sizes;
    """
    assert browser.run(script) == [400, 40]
