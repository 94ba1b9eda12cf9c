// Uploads files with XMLHttpRequest, because fetch does not report the progress of an upload.
import {Aborted, Offline, commonHeaders, refusalOf, withToken} from "./client";

function put<T>(path: string, body: Blob, progress: (share: number) => void, stop: AbortSignal, headers: Record<string, string>): Promise<T> {
  return new Promise((done, failed) => {
    const request = new XMLHttpRequest();
    request.open("PUT", path);
    for (const [name, value] of Object.entries({...commonHeaders("PUT"), ...headers, "Content-Type": "application/octet-stream"})) request.setRequestHeader(name, value);
    request.upload.onprogress = ({loaded, total}) => progress(loaded / Math.max(total, 1));
    request.upload.onload = () => progress(1);
    request.onerror = () => failed(new Offline("the connection broke"));
    request.onabort = () => failed(new Aborted());
    request.onload = () => {
      if (request.status < 200 || request.status >= 300) return failed(refusalOf(request.status, request.responseText));
      done(JSON.parse(request.responseText) as T);
    };
    stop.addEventListener("abort", () => request.abort());
    if (stop.aborted) return failed(new Aborted());
    request.send(body);
  });
}

/** Sends the bytes with PUT. Calls `progress` with the fraction sent, [0, 1]; at 1 the server still works on them. */
export const upload = <T,>(path: string, body: Blob, progress: (share: number) => void, stop: AbortSignal, headers: Record<string, string> = {}): Promise<T> =>
  withToken(() => put<T>(path, body, progress, stop, headers));
