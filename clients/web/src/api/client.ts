// Calls the server. An error answer is thrown as a Refusal with its problem document.
import type {CommandAnswer, Comparison, FrameCounters, FrameEstimate, FrameRequest, Knobs, LogEntry, Pick, Problem, RecipeStep, Scene, SceneList, Settings, TraceReport} from "./types";
import {author, otherToken, token} from "./identity";

/** The server refused the request; `problem` says why. */
export class Refusal extends Error {
  constructor(readonly status: number, readonly problem: Problem) {
    super(problem.detail || problem.title);
  }
}
/** The server did not answer. */
export class Offline extends Error {}
/** The sender aborted the request. */
export class Aborted extends Error {}

export interface CallOptions { method?: string; body?: BodyInit | null; json?: unknown; headers?: Record<string, string>; signal?: AbortSignal; keepalive?: boolean }

/** Reasons by HTTP status, for answers that are not problem documents, such as those of a proxy. */
const reasons: Record<number, string> = {
  401: "it needs a token", 403: "it is forbidden", 404: "there is nothing at this address", 408: "the request took too long", 413: "the request is too large",
  429: "too many requests came at once", 502: "the server behind the proxy does not answer", 503: "the server is not running or too busy",
  504: "the server behind the proxy took too long",
};

/** Makes a problem document for an answer without one, from its first line of plain text or its status. */
function fallbackProblem(status: number, text: string): Problem {
  const line = /^\s*[<{]/.test(text) ? "" : text.trim().split("\n")[0]!.slice(0, 160);
  const reason = line || reasons[status] || (status >= 500 ? "the server failed" : "no reason was given");
  return {type: "about:blank", title: "The request failed.", status, detail: `The request was answered with ${status}: ${reason}.`};
}

/** Returns the headers of every request. */
export function commonHeaders(method: string): Record<string, string> {
  const headers: Record<string, string> = {};
  if (token.value) headers["Authorization"] = `Bearer ${token.value}`;
  if (method !== "GET") headers["Pelage-Author"] = encodeURIComponent(author.value);
  return headers;
}

/** Returns the Refusal for an error answer. */
export function refusalOf(status: number, text: string): Refusal {
  try {
    const problem = JSON.parse(text) as Partial<Problem> | null;
    if (problem?.detail || problem?.title) return new Refusal(status, {...fallbackProblem(status, ""), ...problem});
  } catch {
    // not JSON
  }
  return new Refusal(status, fallbackProblem(status, text));
}

/** Repeats the attempt with another token while the server asks for one and the user provides it. */
export async function withToken<T>(attempt: () => Promise<T>): Promise<T> {
  for (;;) {
    const tried = token.value;
    try {
      return await attempt();
    } catch (error) {
      if (!(error instanceof Refusal) || error.status !== 401 || !(await otherToken(tried))) throw error;
    }
  }
}

async function callOnce(path: string, options: CallOptions): Promise<Response> {
  const method = options.method ?? (options.json === undefined ? "GET" : "POST");
  const headers: Record<string, string> = {...options.headers, ...commonHeaders(method)};
  if (options.json !== undefined) headers["Content-Type"] = "application/json";
  const body = options.json === undefined ? options.body : JSON.stringify(options.json);
  let answer: Response;
  try {
    answer = await fetch(path, {method, headers, body: body ?? null, signal: options.signal ?? null, cache: "no-store", keepalive: options.keepalive ?? false});
  } catch (error) {
    if (options.signal?.aborted) throw new Aborted();
    throw new Offline(String(error));
  }
  if (answer.ok || answer.status === 304) return answer;
  throw refusalOf(answer.status, await answer.text().catch(() => ""));
}

/** Returns answers with the status 200 to 304; anything else is thrown. */
export const call = (path: string, options: CallOptions = {}): Promise<Response> => withToken(() => callOnce(path, options));

async function read<T>(path: string, options: CallOptions = {}): Promise<T> {
  return await (await call(path, options)).json() as T;
}

const at = (id: string) => `/v1/scenes/${encodeURIComponent(id)}`;

export const listScenes = async () => (await read<SceneList>("/v1/scenes")).scenes;
export const describeScene = (id: string) => read<Scene>(at(id));
export const createScene = (json: unknown) => read<Scene>("/v1/scenes", {json});
export const removeScene = (id: string) => call(at(id), {method: "DELETE", keepalive: true});
export const readLog = async (id: string) => (await read<{entries: LogEntry[]}>(`${at(id)}/log`)).entries;
export const readLines = async (id: string) => (await call(`${at(id)}/log?format=jsonl`)).text();
export const branchScene = (id: string, json: unknown) => read<Scene>(`${at(id)}/branch`, {json});
export const compareRevisions = (id: string, from: number, to: number) => read<Comparison>(`${at(id)}/compare?from=${from}&to=${to}`);
export const pick = (id: string, json: unknown) => read<Pick>(`${at(id)}/pick`, {json});
/** Returns the steps of a recipe for this scene's model; changes nothing. */
export const expandRecipe = async (id: string, json: unknown) => (await read<{steps: RecipeStep[]}>(`${at(id)}/recipe`, {json})).steps;
/** Returns what an amendment would do; changes nothing. */
export const tryAmend = (id: string, json: unknown, signal?: AbortSignal) => read<CommandAnswer>(`${at(id)}/amend?dry_run=1`, {json, ...(signal ? {signal} : {})});
export const scenePath = at;

/** Sends a change of a scene; called by the outbox. `path` is relative to the scene's. `key` makes repeats harmless. */
export const change = (id: string, path: string, json: unknown, key: string) =>
  read<CommandAnswer>(`${at(id)}/${path}`, {json, headers: {"Idempotency-Key": key}});

export interface Picture {
  bytes: Blob;
  revision: number;
  knobs: Knobs;
  trace: TraceReport | null;
  estimate: FrameEstimate | null;
  /** Fraction of the picture that was drawn for this answer, [0, 1]; 0 if it was cached. */
  redrawn: number;
  /** Milliseconds by stage, from the header Server-Timing. */
  timings: Record<string, number>;
}
export interface FrameNews { after: number; after_pass?: number; wait: number }

const json_header = (answer: Response, name: string) => {
  const text = answer.headers.get(name);
  return text === null ? null : JSON.parse(text) as unknown;
};

export function timingsOf(text: string): Record<string, number> {
  const timings: Record<string, number> = {};
  for (const part of text.split(",")) {
    const match = /^\s*(\w+);dur=([\d.]+)/.exec(part);
    if (match) timings[match[1]!] = Number(match[2]);
  }
  return timings;
}

/** Reads an answer's body. Throws Aborted or Offline if the request is aborted or the connection lost meanwhile. */
async function bytesOf(answer: Response, signal?: AbortSignal): Promise<Blob> {
  try {
    return await answer.blob();
  } catch (error) {
    throw signal?.aborted ? new Aborted() : new Offline(String(error));
  }
}

/** Draws a frame; null if nothing newer came within `news.wait` seconds. */
export async function drawFrame(id: string, request: FrameRequest, news: FrameNews | null, signal?: AbortSignal): Promise<Picture | null> {
  const query = news ? "?" + Object.entries(news).map(([name, value]) => `${name}=${value}`).join("&") : "";
  const answer = await call(`${at(id)}/frames${query}`, {json: request, ...(signal ? {signal} : {})});
  if (answer.status === 304) return null;
  return {
    bytes: await bytesOf(answer, signal),
    revision: Number(answer.headers.get("Pelage-Revision")),
    knobs: json_header(answer, "Pelage-Quality") as Knobs,
    trace: json_header(answer, "Pelage-Trace") as TraceReport | null,
    estimate: json_header(answer, "Pelage-Error") as FrameEstimate | null,
    redrawn: (json_header(answer, "Pelage-Counters") as FrameCounters | null)?.redrawn ?? 1,
    timings: timingsOf(answer.headers.get("Server-Timing") ?? ""),
  };
}


export const readSettings = (id: string, revision?: number) =>
  read<Settings>(`${at(id)}/settings${revision === undefined ? "" : `?revision=${revision}`}`);
