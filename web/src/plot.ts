// A number over time.

const kept = 900; // samples

export class Plot {
  readonly element = document.createElement("div");
  private readonly canvas = document.createElement("canvas");
  private readonly value = document.createElement("span");
  private readonly times: number[] = [];
  private readonly values: number[] = [];

  constructor(readonly path: string, remove: () => void) {
    this.element.className = "plot";
    const title = document.createElement("div");
    title.className = "title";
    const name = document.createElement("span");
    name.textContent = name.title = path;
    this.value.className = "value";
    const button = document.createElement("button");
    button.textContent = "×";
    button.title = `Remove ${path}`;
    button.onclick = remove;
    title.append(name, this.value, button);
    this.element.append(title, this.canvas);
  }

  add(time: number, value: number | null): void {
    const last = this.times.at(-1);
    if (last !== undefined && time < last) this.times.length = this.values.length = 0; // time has jumped
    if (time === last || value === null) return;
    this.times.push(time);
    this.values.push(value);
    if (this.times.length > kept) {
      this.times.shift();
      this.values.shift();
    }
    this.value.textContent = short(value);
    this.draw();
  }

  private draw(): void {
    const { clientWidth: width, clientHeight: height } = this.canvas;
    if (width === 0) return;
    const scale = Math.min(window.devicePixelRatio, 2);
    this.canvas.width = width * scale;
    this.canvas.height = height * scale;
    const pen = this.canvas.getContext("2d")!;
    pen.scale(scale, scale);
    let low = Math.min(...this.values), high = Math.max(...this.values);
    if (high - low < 1e-9) [low, high] = [low - 0.5, high + 0.5];
    const begin = this.times[0]!, end = Math.max(this.times.at(-1)!, begin + 1e-3);
    const x = (time: number) => ((time - begin) / (end - begin)) * (width - 2) + 1;
    const y = (value: number) => height - 13 - ((value - low) / (high - low)) * (height - 24);
    pen.strokeStyle = "rgba(255, 255, 255, 0.14)";
    pen.beginPath();
    for (const level of [low, high, ...(low < 0 && high > 0 ? [0] : [])]) {
      pen.moveTo(0, y(level));
      pen.lineTo(width, y(level));
    }
    pen.stroke();
    pen.strokeStyle = "#4ea1ff";
    pen.lineWidth = 1.5;
    pen.beginPath();
    this.values.forEach((value, i) => pen.lineTo(x(this.times[i]!), y(value)));
    pen.stroke();
    pen.fillStyle = "#9aa7b0";
    pen.font = "11px system-ui, sans-serif";
    pen.fillText(short(high), 2, 9);
    pen.fillText(short(low), 2, height - 2);
    const times = `${begin.toFixed(1)} to ${end.toFixed(1)} s`;
    pen.fillText(times, width - pen.measureText(times).width - 2, height - 2);
  }
}

export function short(value: number): string {
  const size = Math.abs(value);
  if (size !== 0 && (size < 1e-3 || size >= 1e5)) return value.toExponential(2);
  return value.toFixed(size < 10 ? 3 : size < 1000 ? 2 : 0);
}
