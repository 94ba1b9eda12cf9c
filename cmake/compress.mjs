// Compresses the files of a folder for the server to serve. usage: node compress.mjs FOLDER
import {readFileSync, readdirSync, writeFileSync} from "node:fs";
import {join} from "node:path";
import {argv} from "node:process";
import {fileURLToPath} from "node:url";
import {brotliCompressSync, constants, gzipSync} from "node:zlib";

/** Writes FILE.br and FILE.gz next to each file, where they save more than 5%. */
export function compress(folder) {
  for (const file of readdirSync(folder, {withFileTypes: true})) {
    const path = join(folder, file.name);
    if (file.isDirectory()) { compress(path); continue; }
    const bytes = readFileSync(path);
    const forms = {br: brotliCompressSync(bytes, {params: {[constants.BROTLI_PARAM_QUALITY]: 11}}), gz: gzipSync(bytes, {level: 9})};
    for (const [ending, small] of Object.entries(forms)) {
      if (small.length < bytes.length * 0.95) writeFileSync(`${path}.${ending}`, small);
    }
  }
}

if (argv[1] === fileURLToPath(import.meta.url)) compress(argv[2]);
