// Cameras by name: the server's automatic ones, and those that the agent has named since this program started.
import {Refusal, unknownName} from "./refusal";

export class Cameras {
  private readonly named = new Map<string, object>();

  /** `automatic` are the names that the server itself knows. */
  constructor(private readonly automatic: readonly string[]) {}

  names(): string[] {
    return [...this.automatic, ...this.named.keys()];
  }

  keep(name: string, camera: unknown) {
    if (this.automatic.includes(name)) throw new Refusal({detail: `The camera "${name}" is the server's own.`, pointer: "/name", limit: "another name"});
    if (typeof camera !== "object" || camera === null) throw new Refusal({detail: '"camera" is no camera.', pointer: "/camera", limit: "a name or an object"});
    this.named.set(name, camera);
  }

  /** Returns a copy of `value` in which camera names in members `camera`, at any depth, are replaced by the cameras. */
  within(value: unknown, pointer = ""): unknown {
    if (Array.isArray(value)) return value.map((one, k) => this.within(one, `${pointer}/${k}`));
    if (typeof value !== "object" || value === null) return value;
    return Object.fromEntries(Object.entries(value).map(([key, one]) => {
      const at = `${pointer}/${key}`;
      return [key, key === "camera" && typeof one === "string" ? this.of(one, at) : this.within(one, at)];
    }));
  }

  private of(name: string, pointer: string): object {
    if (this.automatic.includes(name)) return {auto: name};
    const camera = this.named.get(name);
    if (!camera) throw unknownName(`There is no camera "${name}".`, pointer, name, this.names());
    return camera;
  }
}
