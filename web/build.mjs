// Bundles the page into one HTML file, script and style within it, and compresses that: node build.mjs [folder]
import { mkdirSync, readFileSync, writeFileSync } from "node:fs";
import { join } from "node:path";
import { gzipSync } from "node:zlib";
import { build } from "esbuild";

const folder = process.argv[2] ?? "dist";
const options = { bundle: true, minify: true, write: false, legalComments: "none", logLevel: "warning" };
const text = async (entry, more) => (await build({ ...options, ...more, entryPoints: [entry] })).outputFiles[0].text;
const script = await text("src/main.ts", { format: "iife", target: "es2022" });
const style = await text("src/style.css", {});
const licence = readFileSync("node_modules/three/LICENSE", "utf8").match(/Copyright.*/)[0];
const page = readFileSync("src/index.html", "utf8")
  .replace("/* style */", () => style.trim())
  // what stands in a script must not look like its end
  .replace("/* script */", () => `/* with three.js: MIT License, ${licence} */\n${script.trim().replaceAll("</script", "<\\/script")}`);
mkdirSync(folder, { recursive: true });
writeFileSync(join(folder, "index.html"), page);
writeFileSync(join(folder, "index.html.gz"), gzipSync(page, { level: 9 }));
