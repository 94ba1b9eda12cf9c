// Suggests the known name nearest to a misspelt one.

/** Returns the nearest known name; undefined if none is near. */
export function nearestOf(wrong: string, known: readonly string[]): string | undefined {
  const near = known.map((name) => ({name, distance: distance(wrong.toLowerCase(), name.toLowerCase())}))
    .filter((one) => one.distance <= Math.ceil(wrong.length / 2));
  return near.sort((a, b) => a.distance - b.distance)[0]?.name;
}

/** Returns the Levenshtein distance: the number of letters to insert, remove or replace. */
function distance(from: string, to: string): number {
  let row = Array.from({length: to.length + 1}, (_, k) => k);
  for (const [i, letter] of [...from].entries()) {
    const next = [i + 1];
    for (let j = 0; j < to.length; ++j) next.push(Math.min(next[j]! + 1, row[j + 1]! + 1, row[j]! + (letter === to[j] ? 0 : 1)));
    row = next;
  }
  return row[to.length]!;
}
