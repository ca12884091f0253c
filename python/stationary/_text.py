"""The program's text where it is no terminal's."""

from __future__ import annotations

import html
import re


def plain(text: str) -> str:
    """Without the bold headings that it has in a terminal, and its last line's end."""
    return re.sub("\x1b\\[[0-9;]*m", "", text).rstrip("\n")


def block(text: str) -> str:
    """As it stands, in HTML."""
    return f"<pre>{html.escape(text)}</pre>"
