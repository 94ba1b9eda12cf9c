// Small scenes of a server of their own, and the files that they are exported as.
import {after, before} from "node:test";
import {Server} from "../../studio/support/server.mjs";

let server;

/** Called once, at the top of a test file. `prepare` runs when the server is there. */
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
const few = {op: "set_coat", coat: {count: 100, length_spread: 0.3}};  // some thousand strands

/** A scene of a built-in model with few strands; the answer to GET. */
export async function scene_of(builtin, triangles, ...commands) {
  const {id} = await server.post("/v1/scenes", {name: builtin, model: {builtin, triangles}});
  for (const command of [few, ...commands]) await server.post(`/v1/scenes/${id}/commands`, command);
  return server.get(`/v1/scenes/${id}`);
}

/** The file, and what the server says that it holds. query: As in "cards?cards=300". */
export async function exported({id}, query) {
  const answer = await fetch(`${server.address}/v1/scenes/${id}/export/${query}`);
  if (!answer.ok) throw new Error(`${query}: ${answer.status} ${await answer.text()}`);
  return {bytes: new Uint8Array(await answer.arrayBuffer()), about: JSON.parse(answer.headers.get("pelage-export"))};
}

/** What a dry run says. */
export const dry_run = ({id}, query) => server.get(`/v1/scenes/${id}/export/${query}${query.includes("?") ? "&" : "?"}dry_run=1`);

/** The light mesh of the model, which the studio shows while one grooms. */
export async function light_mesh({id}) {
  return new Uint8Array(await (await fetch(`${server.address}/v1/scenes/${id}/mesh`)).arrayBuffer());
}
