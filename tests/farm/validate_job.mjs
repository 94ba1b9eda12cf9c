// Checks a Kubernetes Job, JSON from standard input, by the schemas of the Kubernetes API. Exit code 1 where it is wrong.
import { readFileSync } from "node:fs";
import { Job } from "kubernetes-models/batch/v1";

try {
  new Job(JSON.parse(readFileSync(0))).validate();
} catch (error) {
  console.error(String(error));
  process.exit(1);
}
