// The tool that exports a scene to a file.
import {writeFile} from "node:fs/promises";
import {extname} from "node:path";
import {Refusal} from "../refusal";
import {pathMember, queryOf, reads, result, scene_member, scenePath, textIn, without, type Answers, type Context, type Tool} from "./tool";

export function exportScene({service, schemas}: Context): Tool {
  const {format, ...options} = schemas.named("ExportRequest").properties ?? {};
  const overwrite = {type: "boolean", default: false, description: "Replace an existing file."};
  return {
    name: "export_scene", annotations: {...reads, readOnlyHint: false, destructiveHint: true},
    description: "Exports the groom for other programs: strands as usda or hair; shells, cards or fields as glTF; or the whole scene as pelage.",
    inputSchema: schemas.input({scene: scene_member, path: pathMember(), format: {...format, description: "Default: the path's extension."}, ...options, overwrite}, ["scene", "path"]),
    run: async (input, caller) => {
      const path = textIn(input, "path"), wanted = String(input["format"] ?? extname(path).slice(1).toLowerCase());
      const query = queryOf(without(input, "scene", "path", "format", "overwrite"));
      const answer = await service.send("GET", `${await scenePath(service, textIn(input, "scene"), caller)}/export/${encodeURIComponent(wanted)}?${query}`, {}, caller);
      const about = JSON.parse(answer.headers.get("Pelage-Export") ?? "{}") as Answers["ExportAbout"];
      await write(path, new Uint8Array(await answer.arrayBuffer()), input["overwrite"] === true);
      return result(`Wrote ${path}: ${about.bytes} bytes, ${about.strands} strands, ${about.triangles} triangles, revision ${about.revision}.`, {path, ...about});
    },
  };
}

async function write(path: string, bytes: Uint8Array, overwrite: boolean) {
  try {
    await writeFile(path, bytes, {flag: overwrite ? "w" : "wx"});
  } catch (error) {
    const {code, message} = error as NodeJS.ErrnoException;
    const detail = code === "EEXIST" ? `"${path}" exists.` : `"${path}" cannot be written: ${message}.`;
    throw new Refusal({detail, pointer: "/path", limit: code === "EEXIST" ? "a new path, or overwrite" : "a path on the machine where pelage-mcp runs"});
  }
}
