// Handle and tunnel loops, measures, Reeb graphs, skeletons and the removal of handles, for triangle meshes.
// Each call runs in a worker of its own; what it throws is an HtloopsError, or the reason of the signal.

export interface Mesh {
  /** Three coordinates a point. */
  points: Float64Array;
  /** Three numbers of points, from 0, a triangle. */
  triangles: Uint32Array;
}

/** Arrays of numbers of any kind are taken; those that come back are the typed ones of `Mesh`. */
export interface MeshLike {
  points: ArrayLike<number>;
  triangles: ArrayLike<number>;
}

export interface Running {
  /** Ends the computation at once. */
  signal?: AbortSignal;
  /** Told the part that is done, 0 to 1, and what is being done. */
  onProgress?: (part: number, what: string) => void;
}

export interface Computing extends Running {
  /** At most so many threads, where there are some; all processors without it. */
  threads?: number;
}

/** What makes a mesh acceptable that is not. */
export interface Remedies {
  triangulate?: boolean;
  repair?: boolean;
  /** A length, or a percentage of the diagonal of the box: points of open edges that near are one. */
  weld?: number | string;
}

export type Point = [number, number, number];

export interface Loop {
  length: number | null;
  component: number;
  bounds: 'inside' | 'outside' | 'neither' | 'undecided';
  /** [u, v, t]: on the edge from vertex u to vertex v, at the part t of it. */
  locations: [number, number, number][];
  /** Three coordinates a point; the first is not repeated at the end. */
  points: Float64Array;
}

export interface Ball {
  diameter: number;
  error: number;
  /** Where the ball is in the narrowest place. */
  throat: Point;
  /** The way of the ball. */
  curve: Point[];
}

export interface Pair {
  /** The length of the shorter loop, relative to the diagonal of the box of the mesh. */
  size: number | null;
  centre: Point;
  box: [Point, Point];
  diameter?: number | null;
  diameter_of?: 'bore' | 'handle' | 'tunnel';
  bore?: { diameter: number; centre: Point; axis: Point };
  /** With `measure`: how thick the handle is, and how wide its hole. */
  thickness?: Ball;
  clear_width?: Ball;
  not_measured_because?: string;
  handle: Loop;
  tunnel: Loop;
}

export interface MeshFacts {
  vertices: number;
  faces: number;
  components: number;
  boundaries: number;
  genus: number;
}

export interface Loops {
  mesh: MeshFacts;
  certificate: {
    closed_on_surface: boolean;
    basis: boolean;
    pairing: boolean;
    types: boolean;
    handles_bound_inside: number | null;
    tunnels_bound_outside: number | null;
  };
  pairs: Pair[];
  boundaries: object[];
  throats?: object[];
  timings: Record<string, number>;
  /** How many there were to compute with. */
  threads: number;
}

export interface LoopsOptions extends Computing, Remedies {
  basis?: 'pure' | 'shortest';
  seed?: number;
  waists?: boolean;
  throats?: boolean;
  noRefine?: boolean;
  noTighten?: boolean;
  noCoarsen?: boolean;
  searchEffort?: number;
  timeBudget?: number;
  measure?: boolean;
  precision?: string;
  removal?: boolean;
}

/** The loops around handles and through their holes, in pairs, with what is certified of them. */
export function loops(mesh: MeshLike, options?: LoopsOptions): Promise<Loops>;

/** The same with the thickness of each handle and the clear width of its hole. */
export function measure(mesh: MeshLike, options?: LoopsOptions): Promise<Loops>;

export interface ReebGraph {
  mesh: MeshFacts;
  cycles: number;
  nodes: { id: number; type: 'minimum' | 'saddle' | 'maximum' | 'regular'; vertex: number; value: number; position: Point }[];
  arcs: { id: number; source: number; target: number; vertex_count: number; length: number; girth: number; polyline: Float64Array }[];
  vertex_arc: number[];
}

export interface ReebOptions extends Computing, Remedies {
  /** The height in this direction instead of a diffusion. */
  height?: Point;
  /** Vertices to diffuse from. */
  seed?: number[];
  simplify?: number;
  shortestArc?: number;
  drawing?: 'inside' | 'means';
}

export function reebGraph(mesh: MeshLike, options?: ReebOptions): Promise<ReebGraph>;

export interface Skeleton {
  mesh: MeshFacts;
  cycles: number;
  certificate: { connected: boolean; inside: boolean; embedded: boolean; cycles: boolean; failure: string };
  nodes: { id: number; position: Point; radius: number; kind: string; component: number }[];
  arcs: { arc: number; component: number; length: number; source: number; target: number; polyline: Point[]; radii: number[] }[];
  vertex_point: number[];
}

/** A curve skeleton that is proved to lie inside. */
export function skeleton(mesh: MeshLike, options?: Computing & Remedies & { shortestLimb?: number }): Promise<Skeleton>;

export interface Changed {
  mesh: Mesh;
  report: Record<string, unknown>;
}

/** Lengths are numbers, or percentages of the diagonal of the box, such as '3%'. One of these is needed. */
export interface RemoveOptions extends Computing, Remedies {
  all?: boolean;
  genus?: number;
  shorterThan?: number | string;
  noiseBelow?: number | string;
  /** Numbers of pairs, as `loops` has them. */
  pairs?: number[];
  box?: number[];
  necks?: number | string;
  channels?: number | string;
  /** Diameters, such as '3:8'. */
  bores?: string;
  by?: 'cut' | 'fill' | 'smallest-change';
  force?: boolean;
  yes?: boolean;
}

export function removeHandles(mesh: MeshLike, options: RemoveOptions): Promise<Changed>;

export interface CleanOptions extends Computing {
  skip?: string[];
  weld?: number | string;
  channels?: number | string;
  floaters?: string;
  genus?: number;
  noiseBelow?: number | string;
}

/** A closed solid, as far as it can be made one: the report tells what is left. */
export function clean(mesh: MeshLike, options?: CleanOptions): Promise<Changed>;

/** The mesh cut open to disks, along short arcs of its edges. */
export function cut(mesh: MeshLike, options?: Computing & Remedies & { through?: number[]; cutSpheres?: boolean }): Promise<{ mesh: Mesh }>;

/** A mesh of a known genus: 'torus', 'multi-torus', 'gyroid', 'lattice', ... */
export function generate(kind: string, options?: { faces?: number; genus?: number; seed?: number; signal?: AbortSignal; [option: string]: unknown }): Promise<Mesh>;

export interface RunOptions extends Running {
  /** Files that the run finds, by name. Their arrays stay yours. */
  files?: Record<string, Uint8Array>;
  /** Names of files that are wanted. */
  outputs?: string[];
  /** The standard input. */
  input?: Uint8Array;
  /** Told each line of the messages. */
  onText?: (line: string) => void;
}

export interface RunResult {
  exitCode: number;
  files: Record<string, Uint8Array>;
  /** The standard output. */
  output: Uint8Array;
  messages: string;
}

/** The command `htloops` with these arguments, on files in memory: all that it can. */
export function run(args: string[], options?: RunOptions): Promise<RunResult>;

/** What the tool said, with the exit code: 1 no certified answer, 2 wrong usage, 3 no mesh that can be read,
 * 4 a mesh that is not accepted; null if the run broke off. */
export class HtloopsError extends Error {
  exitCode: number | null;
  messages: string;
}
