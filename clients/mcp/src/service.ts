// Calls the Pelage server. Any answer but success is thrown as a Refusal.
import {Refusal, type Problem} from "./refusal";

/** The agent's call: `signal` aborts its requests if the agent cancels it, `author` names the agent in the log. */
export interface Caller {
  signal: AbortSignal;
  author: string;
  /** Reports how many parts of a long call are done, so that the agent does not time out. */
  progress(done: number, total: number): Promise<void>;
}

interface Body { json?: unknown; bytes?: Uint8Array }

export class Service {
  constructor(readonly address: string, private readonly token: string | undefined) {}

  async get<T>(path: string, caller: Caller): Promise<T> {
    return await (await this.send("GET", path, {}, caller)).json() as T;
  }

  async post<T>(path: string, json: unknown, caller: Caller): Promise<T> {
    return await (await this.send("POST", path, {json}, caller)).json() as T;
  }

  async put<T>(path: string, bytes: Uint8Array, caller: Caller): Promise<T> {
    return await (await this.send("PUT", path, {bytes}, caller)).json() as T;
  }

  async remove(path: string, caller: Caller): Promise<void> {
    await this.send("DELETE", path, {}, caller);
  }

  /** Returns the raw answer, for bodies that are not JSON and for headers. */
  async send(method: string, path: string, body: Body, caller: Caller): Promise<Response> {
    const init = {method, headers: this.headers(body, caller.author), signal: caller.signal, ...contentOf(body)};
    const answer = await fetch(this.address + path, init).catch((error: unknown) => {
      if (caller.signal.aborted) throw error;
      const cause = (error as {cause?: {message?: string}}).cause?.message ?? String(error);
      throw new Refusal({status: 0, detail: `No Pelage server answers at ${this.address} (${cause}).`});
    });
    if (answer.ok) return answer;
    throw new Refusal(await problemOf(answer));
  }

  private headers(body: Body, author: string): Record<string, string> {
    const headers: Record<string, string> = {"Pelage-Author": encodeURIComponent(author)};
    if (this.token) headers["Authorization"] = `Bearer ${this.token}`;
    if (body.json !== undefined) headers["Content-Type"] = "application/json";
    if (body.bytes) headers["Content-Type"] = "application/octet-stream";
    return headers;
  }
}

function contentOf({json, bytes}: Body): {body?: string | Uint8Array} {
  if (json !== undefined) return {body: JSON.stringify(json)};
  return bytes ? {body: bytes} : {};
}

async function problemOf(answer: Response): Promise<Problem> {
  const text = await answer.text();
  try {
    return {...JSON.parse(text) as Problem, status: answer.status};
  } catch {
    return {status: answer.status, detail: `The server answers ${answer.status}: ${text.slice(0, 200)}`};
  }
}
