// Tools for scenes: list, create, load, describe, remove.
import {readFile} from "node:fs/promises";
import {extname} from "node:path";
import {Refusal, unknownName} from "../refusal";
import {changes, destroys, pathMember, queryOf, reads, result, scene_member, scenePath, textIn, without, arrayIn, type Answers, type Context, type Input, type Tool} from "./tool";
import {sceneInWords} from "./words";

type Scene = Answers["Scene"];

export function sceneTools(context: Context): Tool[] {
  return [listScenes(context), createScene(context), loadModel(context), describeScene(context), readSettings(context), removeScene(context)];
}

function listScenes({service, schemas}: Context): Tool {
  return {
    name: "list_scenes", annotations: reads,
    description: "Lists the server's scenes. A scene is a model with its fur and its undo steps.",
    inputSchema: schemas.input({}, []),
    run: async (_, caller) => {
      const list = await service.get<Answers["SceneList"]>("/v1/scenes", caller);
      const words = list.scenes.map(sceneInWords);
      return result(words.length > 0 ? words.join("\n") : "There are no scenes. `create_scene` makes one.", list);
    },
  };
}

function createScene({service, schemas}: Context): Tool {
  return {
    name: "create_scene", annotations: changes,
    description: "Makes a scene with a built-in model and a first fur. `load_model` can then replace it by a model from a file.",
    inputSchema: schemas.input(schemas.named("NewScene").properties ?? {}, []),
    run: async (input, caller) => {
      const scene = await service.post<Scene>("/v1/scenes", input, caller);
      return result(`${sceneInWords(scene)}\nNext: \`views\` shows it from all sides.`, scene);
    },
  };
}

function loadModel({service, schemas}: Context): Tool {
  const {format, ...options} = schemas.named("ImportOptions").properties ?? {};
  const discard = {type: "boolean", default: false, description: "Start with a new first groom; the scene's groom is lost."};
  const path = pathMember(" Zip a model together with the files it references.");
  return {
    name: "load_model", annotations: destroys,
    description: "Loads a model file into a scene. An ungroomed scene gets a first fur, a groomed one keeps its groom on the new model. "
      + "The undo log starts empty; a groomed scene's old state stays under another id.",
    inputSchema: schemas.input({scene: scene_member, path, format: {...format, description: "Default: the path's extension."}, ...options, discard}, ["scene", "path"]),
    run: async (input, caller) => {
      const file = textIn(input, "path");
      const at = await scenePath(service, textIn(input, "scene"), caller);
      const query = queryOf({
        format: extname(file).slice(1).toLowerCase(), ...without(input, "scene", "path", "discard"), discard: Number(input["discard"] ?? false),
      });
      const scene = await service.put<Scene>(`${at}/model?${query}`, await bytesOf(file), caller);
      const repairs = scene.repairs.map(({code, count}) => `${code}: ${count}`);
      const repaired = repairs.length > 0 ? [`Repaired: ${repairs.join(", ")}.`] : [];
      const transfer = scene.carried ? [`The groom was transferred: ${scene.carried.far} of ${scene.carried.vertices} vertices lie far from the previous model. Scene ${scene.carried.before} is a copy of this one as it was before the load.`] : [];
      const next = "Next: `views`. If the model does not stand upright facing +z, load it again with up and front.";
      return result([sceneInWords(scene), ...repaired, ...transfer, next].join("\n"), scene);
    },
  };
}

async function bytesOf(path: string): Promise<Uint8Array> {
  try {
    return await readFile(path);
  } catch (error) {
    throw new Refusal({detail: `"${path}" cannot be read: ${(error as Error).message}.`, pointer: "/path", limit: "a file on the machine where pelage-mcp runs"});
  }
}

function describeScene({service, schemas}: Context): Tool {
  return {
    name: "describe_scene", annotations: reads,
    description: "Describes a scene: model, box, size, revision, undo steps, edit layers.",
    inputSchema: schemas.input({scene: scene_member}, ["scene"]),
    run: async (input, caller) => {
      const scene = await service.get<Scene>(await scenePath(service, textIn(input, "scene"), caller), caller);
      return result(sceneInWords(scene), scene);
    },
  };
}

function readSettings({service, schemas}: Context): Tool {
  const names = Object.keys(schemas.named("Settings").properties ?? {});
  return {
    name: "read_settings", annotations: reads,
    description: "Coat, look, lights, eyes and all else that `set_...` commands set, as they take it. "
      + "The `groups` of set_curves are `curves` here, the `regions` of set_skin `skin`, the `picture` of set_skin_texture `skin_texture`.",
    inputSchema: schemas.input({scene: scene_member, only: {type: "array", items: {enum: names}, description: "Only these; default: all."}}, ["scene"]),
    run: async (input, caller) => {
      const wanted = input["only"] === undefined ? names : arrayIn(input, "only");
      const unknown = wanted.findIndex((name) => !names.includes(String(name)));
      if (unknown >= 0) throw unknownName(`There is no setting ${JSON.stringify(wanted[unknown])}.`, `/only/${unknown}`, String(wanted[unknown]), names);
      const all = await service.get<Input>(`${await scenePath(service, textIn(input, "scene"), caller)}/settings`, caller);
      const settings = Object.fromEntries(Object.entries(all).filter(([name]) => wanted.includes(name)));
      return result(JSON.stringify(settings), settings);
    },
  };
}

function removeScene({service, schemas}: Context): Tool {
  return {
    name: "remove_scene", annotations: destroys,
    description: "Removes a scene with all its undo steps. This cannot be undone.",
    inputSchema: schemas.input({scene: scene_member}, ["scene"]),
    run: async (input, caller) => {
      const name = textIn(input, "scene");
      await service.remove(await scenePath(service, name, caller), caller);
      return result(`Scene "${name}" is gone.`, {removed: name});
    },
  };
}

export function branchScene({service, schemas}: Context): Tool {
  return {
    name: "branch_scene", annotations: changes,
    description: "Makes a new scene from this one, as it is or was at a revision, to try something without changing this one.",
    inputSchema: schemas.input({scene: scene_member, ...schemas.named("BranchRequest").properties}, ["scene"]),
    run: async (input, caller) => {
      const path = await scenePath(service, textIn(input, "scene"), caller);
      const scene = await service.post<Scene>(`${path}/branch`, without(input, "scene"), caller);
      return result(sceneInWords(scene), scene);
    },
  };
}
