// Plays an agent with the official client of the Model Context Protocol: lays a table by tool calls alone, and follows
// the next step of every refusal.
//   node agent.mjs TRIVET MODELS_FOLDER [http]
// With http by a server that has the layout.json of the folder as its start, else over standard input and output.
import assert from "node:assert/strict";
import { spawn } from "node:child_process";
import { writeFile } from "node:fs/promises";
import { createInterface } from "node:readline";
import { Client } from "@modelcontextprotocol/sdk/client/index.js";
import { StdioClientTransport } from "@modelcontextprotocol/sdk/client/stdio.js";
import { StreamableHTTPClientTransport } from "@modelcontextprotocol/sdk/client/streamableHttp.js";
import Ajv from "ajv/dist/2020.js";

const [trivet, models, http] = process.argv.slice(2);
const client = new Client({ name: "trivet-test", version: "1.0.0" });
let server, url, transport;
if (http) {
  server = spawn(trivet, ["serve", "layout.json"], { cwd: models, stdio: ["ignore", "pipe", "inherit"] });
  for await (const line of createInterface({ input: server.stdout })) {
    url = JSON.parse(line).serving + "/mcp";
    break;
  }
  transport = new StreamableHTTPClientTransport(new URL(url));
} else transport = new StdioClientTransport({ command: trivet, args: ["mcp", models] });
await client.connect(transport);
assert.equal(client.getServerVersion().name, "trivet");
assert.match(client.getInstructions(), /never intersect/);

// Arguments of every call are judged by the tool's own schema first, as clients do.
const { tools } = await client.listTools();
const ajv = new Ajv({ strict: true, allowUnionTypes: true, strictTypes: false });
const judges = new Map(tools.map((tool) => [tool.name, ajv.compile(tool.inputSchema)]));
let refusals = 0;

async function call(name, args = {}) {
  const judge = judges.get(name);
  assert.ok(judge(args), `${name} ${JSON.stringify(args)}: ${ajv.errorsText(judge.errors)}`);
  const result = await client.callTool({ name, arguments: args });
  const { text } = result.content[0];
  if (result.isError) {
    ++refusals;
    assert.match(text, /\nNext: .+\.$/, `${name}: a refusal without a next step: ${text}`);
  }
  return { ok: !result.isError, text, data: result.structuredContent, content: result.content };
}

async function done(name, args) {
  const answer = await call(name, args);
  assert.ok(answer.ok, `${name}: ${answer.text}`);
  return answer;
}

// Falls there, else to the free place nearest to it, else anywhere: as the refusals advise.
async function putOn(support, object, x, y) {
  for (const args of [{ position: [x, y, 0.5] }, { on: support, at: [x, y] }, { on: support, at: "anywhere" }]) {
    const answer = await call("put", { object, ...args });
    if (!answer.ok) continue;
    const { data } = await done("list");
    if (data.objects.find((one) => one.object === object).on.join() === support) return;
    await done("undo");
  }
  assert.fail(`no place for ${object}`);
}

assert.equal((await call("check")).ok, false);
await done("open");
const { files } = (await done("list", { what: "files" })).data;
for (const kind of ["table", "plate", "cup", "spoon"]) assert.ok(files.includes(`${kind}.glb`), kind);
await done("append", { object: "table", model: "table.glb" });
await call("put", { object: "table", position: [0, 0, -1] });
await done("put", { object: "table", position: [0, 0, 0.2] });
await done("fix", { object: "table" });
for (const [guest, x, y] of [[1, 0.35, 0], [2, -0.35, 0], [3, 0, 0.2], [4, 0, -0.2]])
  for (const kind of ["plate", "cup", "spoon"]) {
    await done("append", { object: `${kind} ${guest}`, model: `${kind}.glb` });
    await putOn("table", `${kind} ${guest}`, x, y);
  }
await call("put", { object: "saucer", on: "table" });
const verdict = await done("check");
assert.equal(verdict.data.ok, true, verdict.text);
assert.equal(verdict.data.objects, 13);
const picture = (await done("look", { view: "above", width: 160, height: 120 })).content[1];
assert.equal(picture.mimeType, "image/png");
assert.ok(Buffer.from(picture.data, "base64").subarray(1, 4).equals(Buffer.from("PNG")));
if (http) {
  assert.ok(!judges.has("save"));
  const scene = await fetch(url + "/scene.glb", { headers: { "mcp-session-id": transport.sessionId } });
  assert.equal(scene.status, 200);
  await writeFile(models + "/laid by an agent.glb", Buffer.from(await scene.arrayBuffer()));
} else await done("save", { file: "laid by an agent.glb" });
await assert.rejects(client.callTool({ name: "rm", arguments: {} }), /unknown tool/);
const abort = new AbortController();
const stopped = client.callTool({ name: "look", arguments: { width: 1500, height: 1500 } }, undefined,
  { signal: abort.signal });
abort.abort();
await assert.rejects(stopped);
await client.ping();
assert.ok(refusals >= 3, `${refusals} refusals`);
if (http) await transport.terminateSession();
await client.close();
if (server) {
  server.kill("SIGTERM");
  assert.equal(await new Promise((resolve) => server.on("exit", resolve)), 0);
}
console.log(`laid: ${verdict.data.objects} objects, ${tools.length} tools, ${refusals} refusals, each with a next step`);
