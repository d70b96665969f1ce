// A browser, and pages that murosimf serves. Ends the process with 77 where there is no Chromium or playwright-core.
import { spawn } from "node:child_process";
import { existsSync } from "node:fs";

function skip(why) {
  console.log(`skipped: ${why}`);
  process.exit(77);
}

// Chromium without a screen, from `given` or where distributions have it.
export async function launch(given) {
  const names = ["/usr/bin/chromium", "/usr/bin/chromium-browser", "/usr/bin/google-chrome"];
  const executablePath = given ?? names.find((name) => existsSync(name));
  if (!executablePath) skip("no Chromium (Debian: apt-get install chromium)");
  const { chromium } = await import("playwright-core").catch(() => skip("no playwright-core (npm ci in tests/web)"));
  const args = ["--no-sandbox", "--disable-gpu", "--disable-quic", "--no-first-run", "--disable-background-networking",
    "--disable-component-update", "--disable-sync", "--use-angle=swiftshader", "--enable-unsafe-swiftshader"];
  return chromium.launch({ executablePath, headless: true, args });
}

// Programs that run; they end with this process.
export const children = new Set();
process.on("exit", () => { for (const child of children) child.kill("SIGKILL"); });

// murosimf run ... --web, or replay: its address, and how to end it.
export const serveBy = (program) => async (...words) => {
  const child = spawn(program, [...words, "--web", "0"], { stdio: ["ignore", "ignore", "pipe"] });
  children.add(child);
  let said = "";
  const address = await new Promise((resolve, reject) => {
    child.stderr.on("data", (text) => {
      said += text;
      const found = /page: (\S+)/.exec(said);
      if (found && said.includes("Foxglove:")) resolve(found[1]);
    });
    child.on("exit", () => reject(new Error(said)));
  });
  return { address, said: () => said, end: () => new Promise((done) => { child.on("exit", done); child.kill("SIGKILL"); }) };
};
