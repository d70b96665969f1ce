// The WebSocket to a running simulation (docs/web.md). Lost, it is looked for again.
import { readPoses } from "./poses";
import { SceneDocument } from "./scene";
import type { CameraNote, Drawn, Line, Listener, Source, State } from "./source";

const kinds = { poses: 1, picture: 2, scene: 3 };

interface Waiting {
  resolve(answer: unknown): void;
  reject(error: Error): void;
}

type FromServer =
  | { is: "state"; state: State }
  | { is: "lines"; lines: Line[] }
  | { is: "drawings"; drawings: Drawn[] }
  | ({ is: "camera" } & CameraNote)
  | { is: "values"; time: number; values: Record<string, number | null> }
  | { is: "answer"; id: number; error?: string; result?: unknown };

export class Link implements Source {
  readonly live = true;
  private socket: WebSocket | undefined;
  private readonly waiting = new Map<number, Waiting>();
  private nextId = 1;
  private wait = 500; // [ms] until the next attempt
  private contacts = false;
  private watched: string[] = [];
  private camera: string | null = null;

  constructor(private readonly listener: Listener) {
    this.connect();
  }

  play(): void { this.order({ do: "go_on" }); }
  pause(): void { this.order({ do: "pause" }); }
  step(steps: number): void { this.order({ do: "step", steps }); }
  setSpeed(speed: number | null): void { this.order({ do: "speed", speed }); }
  seek(time: number): void { this.order({ do: "seek", time }); }
  reset(): void { this.order({ do: "reset" }); }
  change(text: string): Promise<unknown> { return this.ask({ do: "change", text }); }
  async namesOf(entity: string): Promise<string[]> { return (await this.ask({ do: "names", entity })) as string[]; }

  setContacts(on: boolean): void {
    this.contacts = on;
    if (this.isOpen()) this.order({ do: "contacts", on }); // else as soon as it is
  }

  async watch(paths: string[]): Promise<unknown> {
    const answer = await this.ask({ do: "watch", paths });
    this.watched = paths;
    return answer;
  }

  look(camera: string | null): void {
    this.camera = camera;
    if (this.isOpen()) this.order({ do: "camera", camera });
  }

  private isOpen(): boolean { return this.socket?.readyState === WebSocket.OPEN; }

  // What fails is said; nobody waits for it.
  private order(what: object): void {
    this.ask(what).catch((error: unknown) => this.listener.connected(true, String((error as Error).message)));
  }

  private ask(what: object): Promise<unknown> {
    return new Promise((resolve, reject) => {
      if (!this.isOpen()) {
        reject(new Error("not connected"));
        return;
      }
      const id = this.nextId++;
      this.waiting.set(id, { resolve, reject });
      this.socket?.send(JSON.stringify({ ...what, id }));
    });
  }

  private connect(): void {
    const address = new URL(window.location.href);
    address.protocol = address.protocol === "https:" ? "wss:" : "ws:";
    address.hash = "";
    const socket = new WebSocket(address, "murosimf.v1");
    socket.binaryType = "arraybuffer";
    this.socket = socket;
    socket.onopen = () => {
      this.wait = 500;
      this.listener.connected(true, "");
      if (this.contacts) this.setContacts(true);
      if (this.watched.length > 0) this.order({ do: "watch", paths: this.watched });
      if (this.camera !== null) this.look(this.camera);
    };
    socket.onmessage = (event: MessageEvent<ArrayBuffer | string>) => this.receive(event.data);
    socket.onclose = (event) => {
      for (const { reject } of this.waiting.values()) reject(new Error("the connection was lost"));
      this.waiting.clear();
      this.listener.connected(false, event.reason);
      window.setTimeout(() => this.connect(), this.wait);
      this.wait = Math.min(2 * this.wait, 5000);
    };
  }

  private receive(data: ArrayBuffer | string): void {
    if (typeof data === "string") this.receiveText(JSON.parse(data) as FromServer);
    else this.receiveBytes(data);
  }

  private receiveBytes(data: ArrayBuffer): void {
    const view = new DataView(data);
    switch (view.getUint8(0)) {
      case kinds.poses:
        this.socket?.send('{"do":"seen"}'); // a new one is sent only to who has seen the ones before
        this.listener.poses(readPoses(data));
        break;
      case kinds.picture:
        this.listener.picture({ width: view.getUint16(2, true), height: view.getUint16(4, true), pixels: new Uint8Array(data, 8) });
        break;
      case kinds.scene:
        this.listener.scene(new SceneDocument(new Uint8Array(data, 4)));
        break;
    }
  }

  private receiveText(message: FromServer): void {
    switch (message.is) {
      case "state": this.listener.state(message.state); break;
      case "lines": this.listener.lines(message.lines); break;
      case "drawings": this.listener.drawings(message.drawings); break;
      case "camera": this.listener.cameraNote(message); break;
      case "values": this.listener.values(message.time, message.values); break;
      case "answer": {
        const waiting = this.waiting.get(message.id);
        this.waiting.delete(message.id);
        if (message.error) waiting?.reject(new Error(message.error));
        else waiting?.resolve(message.result);
        break;
      }
    }
  }
}
