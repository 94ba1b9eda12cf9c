// The tool that makes a dry run of commands; with a camera also a picture of what would change.
import type {CallToolResult} from "@modelcontextprotocol/sdk/types.js";
import type {Caller, Service} from "../service";
import {commandsMember, preview} from "./changes";
import {drawViews} from "./pictures";
import {arrayIn, camera_member, changes, scene_member, scenePath, textIn, type Answers, type Context, type Tool} from "./tool";

export function previewChange(context: Context): Tool {
  const {service, schemas} = context;
  const camera = {...camera_member(context), default: undefined};
  const pictured = "With a camera, also draws pictures: 1 before, 2 after, 3 the change (grey for none, then dark violet to yellow).";
  return {
    name: "preview_change",
    // Not read-only in the strict sense: drawing a picture creates a temporary branch.
    annotations: {...changes, idempotentHint: true},
    description: "Says what commands would do, without changes: vertices touched, mean and largest change of each field. " + pictured,
    inputSchema: schemas.input({scene: scene_member, commands: commandsMember(), camera}, ["scene", "commands"]),
    run: async (input, caller) => {
      const path = await scenePath(service, textIn(input, "scene"), caller);
      const body = {commands: arrayIn(input, "commands")};
      const said = await preview(service, path, body, caller);
      return input["camera"] === undefined ? said : addPicture(said, await drawOnBranch(service, path, body, input["camera"], caller));
    },
  };
}

const addPicture = (said: CallToolResult, drawn: CallToolResult): CallToolResult =>
  ({content: [...drawn.content.slice(0, 1), ...said.content, ...drawn.content.slice(1)], structuredContent: {...said.structuredContent, ...drawn.structuredContent}});

/** Runs the commands on a temporary branch and draws it before, after, and the difference. */
async function drawOnBranch(service: Service, path: string, body: object, camera: unknown, caller: Caller): Promise<CallToolResult> {
  const {id, revision} = await service.post<Answers["Scene"]>(`${path}/branch`, {name: "preview"}, caller);
  const branch = `/v1/scenes/${id}`;
  try {
    await service.post(`${branch}/commands`, body, caller);
    const views = [{camera, revision}, {camera}, {camera, overlay: "difference", overlay_from: revision}];
    return await drawViews(service, branch, {views, width: 384, height: 384}, caller, ["before", "after", "what would change"]);
  } finally {
    // A fresh signal, so that the branch is removed even if the agent has cancelled the call.
    await service.remove(branch, {...caller, signal: new AbortController().signal});
  }
}
