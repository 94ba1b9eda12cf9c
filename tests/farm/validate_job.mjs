// Validates a Kubernetes Job (JSON from standard input) by the schemas of the Kubernetes API. Exits with 1 if invalid.
import { readFileSync } from "node:fs";
import { Job } from "kubernetes-models/batch/v1";

try {
  new Job(JSON.parse(readFileSync(0))).validate();
} catch (error) {
  console.error(String(error));
  process.exit(1);
}
