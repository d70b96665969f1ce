// Drawings of a recording in the page (docs/web.md): each group is a track of versions, of which only what has changed is written.
import type { Drawn, DrawnShape } from "./source";

type Look = [DrawnShape["kind"], number, number, number, number, number, string, number, number[][]?];

interface TrackText {
  entity: number;
  by: string;
  name: string;
  of_robot: boolean;
  frames: number[];
  looks: (number[] | null)[];
  points: number[][];
}

export interface DrawingsText {
  looks: Look[];
  tracks: TrackText[];
}

// From its frame until the next version.
interface Version {
  frame: number;
  looks: number[];
  points: number[]; // [mm]
}

function versionsOf(track: TrackText): Version[] {
  let before: Version = { frame: 0, looks: [], points: [] };
  return track.frames.map((later, i) => {
    const given = track.points[i] ?? [], last = before.points;
    const points = given.length === last.length ? given.map((value, k) => value + last[k]!) : given;
    before = { frame: before.frame + later, looks: track.looks[i] ?? before.looks, points };
    return before;
  });
}

export class Tracks {
  private readonly versions: Version[][];

  constructor(private readonly text: DrawingsText) {
    this.versions = text.tracks.map((track) => versionsOf(track));
  }

  // Of each track the number of the version that is seen at a frame; -1: there is none yet.
  at(frame: number): number[] {
    return this.versions.map((all) => {
      let low = 0, high = all.length;
      while (low < high) {
        const middle = (low + high) >> 1;
        if (all[middle]!.frame <= frame) low = middle + 1;
        else high = middle;
      }
      return low - 1;
    });
  }

  drawn(numbers: number[]): Drawn[] {
    const all: Drawn[] = [];
    this.text.tracks.forEach((track, i) => {
      const version = this.versions[i]![numbers[i]!];
      if (!version || version.looks.length === 0) return;
      let one = all.find((known) => known.entity === track.entity && known.by === track.by);
      if (!one) all.push(one = { entity: track.entity, by: track.by, groups: [] });
      one.groups.push({ name: track.name, of_robot: track.of_robot, shapes: this.shapes(version) });
    });
    return all;
  }

  private shapes(version: Version): DrawnShape[] {
    let next = 0;
    const meters = () => (version.points[next++] ?? 0) / 1000;
    return version.looks.map((number) => {
      const [kind, size, red, green, blue, opacity, words, count, triangles] = this.text.looks[number]!;
      const points = Array.from({ length: count }, () => [meters(), meters(), meters()]);
      return { kind, points, size, color: [red, green, blue], opacity, words, triangles: triangles ?? [] };
    });
  }
}
