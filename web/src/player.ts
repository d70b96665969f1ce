// Plays the recording that stands in the page itself (docs/web.md): no server, no network.
import { blend, readPoses, type Poses } from "./poses";
import { SceneDocument } from "./scene";
import type { EntityState, Line, Listener, Source } from "./source";
import { type DrawingsText, Tracks } from "./tracks";

interface RecordingText {
  scene_bytes: number;
  frames: number;
  words: number; // numbers of 16 bits of a frame
  lines: Line[];
  entities: EntityState[];
  drawings?: DrawingsText;
}

async function unpacked(base64: string): Promise<ArrayBuffer> {
  const text = atob(base64.trim());
  const bytes = Uint8Array.from(text, (letter) => letter.charCodeAt(0));
  const stream = new Blob([bytes]).stream().pipeThrough(new DecompressionStream("gzip"));
  return new Response(stream).arrayBuffer();
}

// Frames are stored word by word: of each the differences from frame to frame, low bytes of all, then high bytes of all.
function frames(bytes: Uint8Array, count: number, words: number): ArrayBuffer[] {
  const all = Array.from({ length: count }, () => new ArrayBuffer(2 * words));
  const views = all.map((frame) => new DataView(frame));
  for (let word = 0; word < words; ++word) {
    const low = 2 * word * count, high = low + count;
    let value = 0;
    for (let i = 0; i < count; ++i) {
      value = (value + bytes[low + i]! + 256 * bytes[high + i]!) & 0xffff;
      views[i]!.setUint16(2 * word, value, true);
    }
  }
  return all;
}

const longestPause = 0.5; // [s] between two frames of one clip

export class Player implements Source {
  readonly live = false;
  private frames: Poses[] = [];
  private text: RecordingText | undefined;
  private tracks: Tracks | undefined;
  private drawn = ""; // versions of the tracks
  private time = 0;
  private paused = false;
  private speed = 1;
  private last: number | undefined;

  constructor(private readonly listener: Listener, recording: string) {
    this.load(recording).catch((error: unknown) => listener.connected(false, `this recording cannot be read: ${String(error)}`));
  }

  play(): void {
    if (this.time >= this.end()) this.time = this.begin();
    this.paused = false;
    this.tell();
  }
  pause(): void {
    this.paused = true;
    this.tell();
  }
  step(steps: number): void {
    this.paused = true;
    const next = this.frames.findIndex((frame) => frame.time > this.time + 1e-9);
    const now = next < 0 ? this.frames.length - 1 : next - 1;
    const to = this.frames[Math.min(this.frames.length - 1, Math.max(0, now + steps))];
    if (to) this.seek(to.time);
  }
  setSpeed(speed: number | null): void {
    this.speed = speed ?? 20;
    this.tell();
  }
  seek(time: number): void {
    this.time = Math.min(this.end(), Math.max(this.begin(), time));
    this.show();
    this.tell();
  }
  reset(): void { this.seek(this.begin()); }
  setContacts(): void { /* it has none */ }
  watch(): Promise<unknown> { return Promise.reject(new Error("a recording has no numbers")); }
  look(): void { /* it has no pictures */ }
  change(): Promise<unknown> { return Promise.reject(new Error("a recording cannot be changed")); }
  namesOf(): Promise<string[]> { return Promise.resolve([]); }

  private begin(): number { return this.frames[0]?.time ?? 0; }
  private end(): number { return this.frames.at(-1)?.time ?? 0; }

  private async load(recording: string): Promise<void> {
    const data = await unpacked(recording);
    const length = new DataView(data).getUint32(0, true);
    this.text = JSON.parse(new TextDecoder().decode(new Uint8Array(data, 4, length))) as RecordingText;
    const scene = 4 + length, planes = scene + this.text.scene_bytes;
    this.listener.connected(true, "");
    this.listener.scene(new SceneDocument(new Uint8Array(data, scene, this.text.scene_bytes)));
    this.frames = frames(new Uint8Array(data, planes), this.text.frames, this.text.words).map((frame) => readPoses(frame));
    this.listener.lines(this.text.lines);
    if (this.text.drawings) this.tracks = new Tracks(this.text.drawings);
    this.time = this.begin();
    this.show();
    this.tell();
    const tick = (now: number) => {
      this.advance(now);
      window.requestAnimationFrame(tick);
    };
    window.requestAnimationFrame(tick);
  }

  private advance(now: number): void {
    const passed = this.last === undefined ? 0 : (now - this.last) / 1000;
    this.last = now;
    if (this.paused || passed === 0) return;
    this.time = Math.min(this.end(), this.time + this.speed * Math.min(passed, 0.25));
    this.time = this.afterGap(this.time);
    this.paused = this.time >= this.end();
    this.show();
    this.tell();
  }

  // Clips follow each other without what lies between them.
  private afterGap(time: number): number {
    const next = this.frames.findIndex((frame) => frame.time > time);
    const a = this.frames[next - 1], b = this.frames[next];
    return a && b && b.time - a.time > longestPause ? b.time : time;
  }

  private show(): void {
    const after = this.frames.findIndex((frame) => frame.time > this.time);
    const next = after < 0 ? this.frames.length - 1 : Math.max(1, after);
    const a = this.frames[Math.max(0, next - 1)], b = this.frames[next];
    if (!a || !b) return;
    const share = b.time > a.time ? Math.min(1, Math.max(0, (this.time - a.time) / (b.time - a.time))) : 1;
    this.listener.poses(share === 1 ? b : blend(a, b, share));
    this.draw(this.time >= b.time ? next : next - 1);
  }

  // What was drawn at that frame, if it is not seen already.
  private draw(frame: number): void {
    if (!this.tracks) return;
    const versions = this.tracks.at(frame), now = versions.join();
    if (now === this.drawn) return;
    this.drawn = now;
    this.listener.drawings(this.tracks.drawn(versions));
  }

  private tell(): void {
    this.listener.state({ time: this.time, begin: this.begin(), end: this.end(), paused: this.paused, speed: this.speed,
      factor: this.paused ? 0 : this.speed, branch: 0, entities: this.text?.entities ?? [], game: null });
  }
}
