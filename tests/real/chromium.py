"""Debian's Chromium without a window, for tests of the pages that we write. It waits for states, never for a time."""

from __future__ import annotations

import json
import shutil
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from pathlib import Path
from typing import Any

from absent import absent

PATIENCE = 30
"""Seconds after which a test gives up; a loaded machine is slow."""
FLAGS = ("--headless=new", "--no-sandbox", "--disable-gpu", "--disable-dev-shm-usage", "--window-size=1400,900")
AXE_RUN = """
const done = arguments[arguments.length - 1];
axe.run({resultTypes: ["violations"]}).then(
  (found) => done(found.violations.map((each) => [each.impact, each.id, each.nodes.map((node) => node.html)])),
  (error) => done([["critical", String(error), []]]));
"""


class Browser:
    """One window, and what pages ask of it in words of tests."""

    def __init__(self, driver: Any) -> None:
        self.driver = driver
        driver.set_page_load_timeout(PATIENCE)
        driver.set_script_timeout(PATIENCE)

    def open(self, page: Path) -> None:
        self.driver.get_log("performance")
        self.driver.get_log("browser")
        self.driver.get(page.as_uri())

    def run(self, script: str, *values: object) -> Any:
        return self.driver.execute_script(script, *values)

    def text(self, selector: str) -> str:
        return self.run("return document.querySelector(arguments[0]).textContent", selector)

    def find(self, selector: str) -> Any:
        return self.driver.find_element("css selector", selector)

    def wait(self, holds: Callable[[], object]) -> None:
        from selenium.webdriver.support.ui import WebDriverWait

        WebDriverWait(self.driver, PATIENCE).until(lambda _: holds())

    def shows(self, selector: str, text: str) -> None:
        """Wait until an element has a text; the failure says which it has."""
        from selenium.common.exceptions import TimeoutException

        try:
            self.wait(lambda: self.text(selector) == text)
        except TimeoutException:
            raise AssertionError(f"{selector} shows {self.text(selector)!r}, not {text!r}") from None

    def choose(self, selector: str, option: str) -> None:
        """Choose by keys, as people do: chromedriver's own way sends no `input` event."""
        from selenium.webdriver import Keys

        options = self.run(
            "return [...document.querySelector(arguments[0]).options].map((each) => each.text)", selector
        )
        self.find(selector).send_keys(Keys.HOME + Keys.ARROW_DOWN * options.index(option))

    def color_scheme(self, name: str) -> None:
        features = [{"name": "prefers-color-scheme", "value": name}]
        self.driver.execute_cdp_cmd("Emulation.setEmulatedMedia", {"features": features})

    def requests(self) -> list[str]:
        """Return the addresses that were asked for since a page was opened, but for files."""
        events = [json.loads(entry["message"])["message"] for entry in self.driver.get_log("performance")]
        urls = [each["params"]["request"]["url"] for each in events if each["method"] == "Network.requestWillBeSent"]
        return [url for url in urls if not url.startswith("file:")]

    def complaints(self) -> list[str]:
        """Return what the console says: errors of scripts, and what the page's policy refuses."""
        return [entry["message"] for entry in self.driver.get_log("browser")]

    def hindrances(self) -> list[tuple[str, str, list[str]]]:
        """Return what axe finds that is serious or worse: impact, rule, elements."""
        import axe_core_python

        code = (Path(axe_core_python.__file__).parent / "axe.min.js").read_text("utf-8")
        self.driver.execute_cdp_cmd("Runtime.evaluate", {"expression": code})
        found = self.driver.execute_async_script(AXE_RUN)
        return [each for each in found if each[0] in ("serious", "critical")]


@contextmanager
def started_browser() -> Iterator[Browser]:
    """Start Chromium, or skip; and end it."""
    program, driver = shutil.which("chromium"), shutil.which("chromedriver")
    if not program or not driver:
        absent("needs Debian's chromium and chromium-driver")
    try:
        import axe_core_python  # noqa: F401
        from selenium import webdriver
    except ImportError as error:
        absent(f"needs the extra `test`: {error}")
    options = webdriver.ChromeOptions()
    options.binary_location = program
    for flag in FLAGS:
        options.add_argument(flag)
    options.set_capability("goog:loggingPrefs", {"browser": "ALL", "performance": "ALL"})
    started = webdriver.Chrome(options=options, service=webdriver.ChromeService(driver))
    try:
        yield Browser(started)
    finally:
        started.quit()
