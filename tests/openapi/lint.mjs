// Lints the contract that the build generates, with Redocly's recommended rules and our own.
//
// usage: lint.mjs OPENAPI_JSON
import {createConfig, lint} from "@redocly/openapi-core";
import {plugin} from "./rules.mjs";

const valid = {severity: "error", allowAdditionalProperties: true};  // the schemas themselves are closed

export const config = await createConfig({
  extends: ["recommended-strict"],
  plugins: [plugin],
  rules: {
    "no-invalid-media-type-examples": valid,
    "no-invalid-parameter-examples": valid,
    "no-invalid-schema-examples": valid,
    "operation-operationId-unique": "error",
    "path-parameters-defined": "error",
    "no-path-trailing-slash": "error",
    "operation-4xx-response": "off",   // each operation describes its refusals by `default`
    "no-unused-components": "off",     // the rule does not see members that parameters refer to
    "pelage/described": "error",
    "pelage/whole-sentences": "error",
    "pelage/exampled": "error",
    "pelage/measured": "error",
  },
});

export const problems_of = async (file) =>
  (await lint({ref: file, config})).map(({ruleId, message, location}) => ({rule: ruleId, message, at: location[0].pointer}));

if (process.argv[1] === new URL(import.meta.url).pathname) {
  const problems = await problems_of(process.argv[2]);
  for (const {rule, message, at} of problems) console.error(`${rule} ${at}: ${message}`);
  console.log(`${problems.length} problems`);
  process.exitCode = problems.length === 0 ? 0 : 1;
}
