// Letters on a dark plate that always face the eye.
import { CanvasTexture, Sprite, SpriteMaterial, SRGBColorSpace } from "three";

// `size` [m]: height in the scene; 0: the same on the screen from everywhere.
export function label(text: string, color: string, size = 0): Sprite {
  const canvas = document.createElement("canvas");
  const pen = canvas.getContext("2d")!;
  const letters = 36, font = `600 ${letters}px system-ui, sans-serif`;
  pen.font = font;
  canvas.width = Math.ceil(pen.measureText(text).width) + 26;
  canvas.height = letters + 16;
  pen.font = font;
  pen.fillStyle = "rgba(18, 24, 29, 0.78)";
  pen.beginPath();
  pen.roundRect(0, 0, canvas.width, canvas.height, 12);
  pen.fill();
  pen.fillStyle = color;
  pen.fillRect(0, canvas.height - 5, canvas.width, 5);
  pen.fillStyle = "#fff";
  pen.fillText(text, 13, letters + 1);
  const texture = new CanvasTexture(canvas);
  texture.colorSpace = SRGBColorSpace;
  const sprite = new Sprite(new SpriteMaterial({ map: texture, sizeAttenuation: size > 0, depthTest: false }));
  const height = size > 0 ? (size * canvas.height) / letters : 0.024;
  sprite.scale.set((height * canvas.width) / canvas.height, height, 1);
  sprite.center.set(0.5, size > 0 ? 0.5 : -0.25);
  sprite.renderOrder = 10;
  return sprite;
}
