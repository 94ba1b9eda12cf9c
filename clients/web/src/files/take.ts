// Collects files that were dropped or chosen, with their paths, also from folders.

/** File extensions of pictures that can be skin textures. */
export const skin_endings = /\.(png|jpe?g|webp|bmp|gif)$/i;

export interface InputFile { path: string; file: File }

const max_files = 4000;

const readAll = (reader: FileSystemDirectoryReader): Promise<FileSystemEntry[]> => new Promise((done, failed) => {
  const all: FileSystemEntry[] = [];
  const next = () => reader.readEntries((some) => {  // returns about a hundred at a time
    if (some.length === 0 || all.length > max_files) return done(all);
    all.push(...some);
    next();
  }, failed);
  next();
});

async function collectFiles(entry: FileSystemEntry, found: InputFile[]) {
  if (found.length >= max_files) return;
  if (entry.isFile) {
    const file = await new Promise<File>((done, failed) => (entry as FileSystemFileEntry).file(done, failed));
    found.push({path: entry.fullPath.replace(/^\//, ""), file});
    return;
  }
  for (const inner of await readAll((entry as FileSystemDirectoryEntry).createReader())) await collectFiles(inner, found);
}

/** Returns the dropped files. Call it inside the drop handler, because the browser empties `data` afterwards. */
export function takeDropped(data: DataTransfer): Promise<InputFile[]> {
  const entries = [...data.items].map((item) => item.webkitGetAsEntry()).filter((entry) => entry !== null);
  const plain = [...data.files].map((file) => ({path: file.name, file}));
  if (entries.length === 0) return Promise.resolve(plain);
  return (async () => {
    const found: InputFile[] = [];
    for (const entry of entries) await collectFiles(entry, found);
    return found;
  })();
}

export const takeChosen = (files: FileList): InputFile[] => [...files].map((file) => ({path: file.webkitRelativePath || file.name, file}));

export const endingOf = (path: string) => /\.([^./]+)$/.exec(path)?.[1]?.toLowerCase() ?? "";
export const baseOf = (path: string) => path.replaceAll("\\", "/").split("/").pop()!;
export const folderOf = (path: string) => path.slice(0, path.lastIndexOf("/") + 1);

function normalizedPath(path: string): string {
  const parts: string[] = [];
  for (const part of path.replaceAll("\\", "/").split("/")) {
    if (part === "..") parts.pop();
    else if (part !== "." && part !== "") parts.push(part);
  }
  return parts.join("/").toLowerCase();
}

/** Finds the file that `from` references as `name`: by its path, else by its file name alone, ignoring case. */
export function findNamed(all: InputFile[], from: string, name: string): InputFile | undefined {
  const wanted = normalizedPath(folderOf(from) + name);
  return all.find(({path}) => normalizedPath(path) === wanted) ?? all.find(({path}) => baseOf(path).toLowerCase() === baseOf(name).toLowerCase());
}
