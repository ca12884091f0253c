"""The chapter of the documentation: its `python` blocks are run in order, beside the cases, and what
they print is compared with the `text` block after each. "…" stands for anything."""

import contextlib
import io
import re

import pytest
from conftest import SOURCES

CHAPTER = SOURCES / "docs" / "python.md"


def blocks():
    """(code, what it prints or None, line)."""
    text = CHAPTER.read_text()
    for found in re.finditer(r"```python\n(.*?)```\n(?:\n?```text\n(.*?)```)?", text, re.S):
        yield found[1], found[2], text[: found.start()].count("\n") + 1


def matches(expected, printed):
    pattern = ".*?".join(re.escape(part) for part in expected.rstrip().split("…"))
    return re.fullmatch(pattern, printed.rstrip(), re.S) is not None


@pytest.mark.filterwarnings("ignore::RuntimeWarning")
def test_the_chapter_runs(tmp_path, monkeypatch):
    pytest.importorskip("pandas")
    pytest.importorskip("matplotlib")
    pytest.importorskip("sympy")
    pytest.importorskip("xarray")
    (tmp_path / "cases").symlink_to(SOURCES / "cases")
    monkeypatch.chdir(tmp_path)
    names, count = {}, 0
    for code, expected, line in blocks():
        printed = io.StringIO()
        with contextlib.redirect_stdout(printed):
            exec(compile("\n" * line + code, str(CHAPTER), "exec"), names)
        if expected is not None:
            count += 1
            assert matches(expected, printed.getvalue()), f"line {line}:\n{printed.getvalue()}"
    assert count >= 5
    assert (tmp_path / "first_instability.svg").exists()
