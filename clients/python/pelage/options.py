"""Options that are sent with a command."""

from __future__ import annotations

import urllib.parse
from typing import Dict, NamedTuple, Optional


class Options(NamedTuple):
    """author: Who makes the change. dry_run: True to change nothing. if_match: The only revision to run at."""

    author: Optional[str] = None
    dry_run: bool = False
    if_match: Optional[int] = None

    @property
    def headers(self) -> Dict[str, str]:
        headers = {}
        if self.author is not None:
            headers["Pelage-Author"] = urllib.parse.quote(self.author, safe="")
        if self.if_match is not None:
            headers["If-Match"] = f'"{self.if_match}"'
        return headers

    @property
    def query(self) -> Dict[str, str]:
        return {"dry_run": "1"} if self.dry_run else {}
