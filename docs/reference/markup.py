"""Helpers that write HTML: text with inline code, tables, code blocks, and the frame of a page."""

from __future__ import annotations

import html
import re
from typing import Iterable, List, Optional, Sequence, Tuple

Links = Sequence[Tuple[str, str, bool]]  # text, address, true for the current page

escape = html.escape


def inline(text: str) -> str:
    """Escapes text and turns `names` into <code>."""
    return re.sub(r"`([^`]+)`", r"<code>\1</code>", escape(" ".join(text.split()), quote=False))


def paragraphs(text: str) -> str:
    """Splits text into paragraphs: at blank lines, and where a sentence ends before a line that begins with `word: `."""
    return "".join(f"<p>{inline(part)}</p>\n" for part in re.split(r"\n\s*\n|\.\n(?=[A-Za-z_]+: )", text.strip()) if part)


def code(text: str, language: str) -> str:
    return f'<pre class="{language}"><code>{escape(text.strip(), quote=False)}</code></pre>\n'


def link(text: str, address: str) -> str:
    return f'<a href="{escape(address)}">{inline(text)}</a>'


def table(heads: Sequence[str], rows: Iterable[Sequence[str]], kind: str = "members") -> str:
    """Writes a table. Cells are HTML; the first cell of a row is its heading. Columns that are empty in all rows are left out."""
    cells = [list(row) for row in rows]
    used = [k for k in range(len(heads)) if k == 0 or any(row[k] for row in cells)]
    lines = [f'<div class="wide"><table class="{kind}">', "<thead><tr>" + "".join(f'<th scope="col">{escape(heads[k])}</th>' for k in used) + "</tr></thead>", "<tbody>"]
    for row in cells:
        rest = "".join(f'<td data-head="{escape(heads[k])}">{row[k]}</td>' for k in used[1:])
        lines.append(f'<tr><th scope="row">{row[0]}</th>{rest}</tr>')
    return "\n".join([*lines, "</tbody></table></div>", ""])


def navigation(groups: Sequence[Tuple[str, Links]]) -> str:
    lines: List[str] = []
    for title, links in groups:
        lines.append(f'<details open><summary>{escape(title)}</summary><ul>')
        for text, address, active in links:
            current = ' aria-current="page"' if active else ""
            lines.append(f'<li><a href="{escape(address)}"{current}>{escape(text)}</a></li>')
        lines.append("</ul></details>")
    return "\n".join(lines)


def page(title: str, above: Optional[str], body: str, sidebar: str, version: str) -> str:
    """Writes a whole page. `above`: a line above the title that says what kind of page it is, if any."""
    return f"""<!doctype html>
<html lang="en">
<head>
<meta charset="utf-8">
<meta name="viewport" content="width=device-width, initial-scale=1">
<meta name="color-scheme" content="light dark">
<title>{escape(title)} – Pelage reference</title>
<link rel="stylesheet" href="style.css">
</head>
<body>
<a class="skip" href="#content">Skip to the content</a>
<header class="bar"><a class="brand" href="index.html">Pelage <span>reference</span></a><span class="version">contract {escape(version)}</span><a class="menu" href="#pages">All pages</a></header>
<div class="frame">
<nav id="pages" aria-label="Pages">
{sidebar}
</nav>
<main id="content">
{f'<p class="kind">{escape(above)}</p>' if above else ""}
{body}
</main>
</div>
</body>
</html>
"""
