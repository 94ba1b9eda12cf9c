// Starts a server, makes small scenes on it, and exports them as files.
import {get as http_get} from "node:http";
import {after, before} from "node:test";
import {Server} from "../../studio/support/server.mjs";

let server;

/** Starts the server for a test file; call it once, at the top. `prepare` makes the scenes. */
export function start(prepare = async () => {}) {
  before(async () => {
    server = await Server.start(["--gl", "none"]);
    await prepare();
  });
  after(() => server?.stop());
}

export const eyes = {op: "set_eyes", eyes: [
  {position: [-0.0855, 0.8625, 0.5155], radius: 0.0195, gaze: [-0.3, 0, 1], lids: {}},
  {position: [0.0855, 0.8625, 0.5155], radius: 0.0195, gaze: [0.3, 0, 1], pupil: {shape: "slit", size: 0.4}}]};
export const whiskers = {op: "set_curves", groups: [{curves: [[[-0.06, 0.8, 0.62], [-0.16, 0.82, 0.65], [-0.28, 0.8, 0.62]],
  [[0.06, 0.8, 0.62], [0.28, 0.8, 0.62]]]}]};
export const nose = {op: "set_skin", regions: [{centre: [0, 0.79, 0.63], radii: [0.04, 0.03, 0.04], colour: "#302020"}]};
export const bare = {op: "paint", flood: true, field: "density", value: 0, brush: {strength: 1}};
export const coat = {count: 100, length_spread: 0.3};  // gives some thousand strands
const few = {op: "set_coat", coat};

/** Makes a scene of a built-in model with few strands. Returns the answer to GET. */
export async function scene_of(builtin, triangles, ...commands) {
  const {id} = await server.post("/v1/scenes", {name: builtin, model: {builtin, triangles}});
  for (const command of [few, ...commands]) await server.post(`/v1/scenes/${id}/commands`, command);
  return server.get(`/v1/scenes/${id}`);
}

/** Gets a body and its headers, over a new connection: readers work for seconds without a break, after which node 18 would
 * reuse a connection that the server has closed. */
async function get(path) {
  const answer = await new Promise((done, failed) => http_get(server.address + path, {agent: false}, done).on("error", failed));
  const parts = [];
  for await (const part of answer) parts.push(part);
  const bytes = new Uint8Array(Buffer.concat(parts));
  if (answer.statusCode !== 200) throw new Error(`${path}: ${answer.statusCode} ${new TextDecoder().decode(bytes)}`);
  return {bytes, headers: answer.headers};
}

/** Returns an exported file, and the server's description of it. `query` is for example "cards?cards=300". */
export async function exported({id}, query) {
  const {bytes, headers} = await get(`/v1/scenes/${id}/export/${query}`);
  return {bytes, about: JSON.parse(headers["pelage-export"])};
}

/** Returns the description of a dry run. */
export async function dry_run({id}, query) {
  const {bytes} = await get(`/v1/scenes/${id}/export/${query}${query.includes("?") ? "&" : "?"}dry_run=1`);
  return JSON.parse(new TextDecoder().decode(bytes));
}

/** Returns the simplified mesh of the model that the studio shows while one grooms. */
export const light_mesh = async ({id}) => (await get(`/v1/scenes/${id}/mesh`)).bytes;
