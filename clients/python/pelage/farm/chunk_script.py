"""The script that every engine runs for a chunk: it passes one line of chunks.txt to pelage-render."""

from __future__ import annotations

import shlex

# The shell execs pelage-render, so that a signal to the task's first process reaches it.
CHUNK_SCRIPT = """\
#!/bin/sh
# Draws the frames in line N + 1 of chunks.txt that are not there yet, or a tile of them. usage: sh chunk.sh N
cd "$(dirname "$0")" || exit 1
read -r frames tile <<END
$(sed -n "$(($1 + 1))p" chunks.txt)
END
[ -n "$frames" ] || {{ echo "openjd_fail: chunks.txt has no line for chunk $1"; exit 2; }}
renderer={renderer}
exec "${{PELAGE_RENDER:-$renderer}}" job.json "--frames=$frames" ${{tile:+"--tile=$tile"}} --skip-existing --threads {threads}
"""


def chunk_script(renderer: str, threads: int) -> str:
    """Returns the script. renderer: Program name or path. threads: 0 for all cores of the task."""
    given = str(threads) if threads else '"${SLURM_CPUS_ON_NODE:-0}"'
    return CHUNK_SCRIPT.format(renderer=shlex.quote(renderer), threads=given)
