// Handle and tunnel loops, measures, Reeb graphs, skeletons and the removal of handles, for triangle meshes.
// Each call runs in its own worker, and throws an HtloopsError, or the reason of the signal.

export interface Mesh {
  /** Three coordinates for each point. */
  points: Float64Array;
  /** Three numbers of points, from 0, for each triangle. */
  triangles: Uint32Array;
}

/** Any arrays of numbers are accepted; results are the typed arrays of `Mesh`. */
export interface MeshLike {
  points: ArrayLike<number>;
  triangles: ArrayLike<number>;
}

export interface Running {
  /** Ends the computation at once. */
  signal?: AbortSignal;
  /** Called with the fraction that is done, 0 to 1, and the current step. */
  onProgress?: (part: number, what: string) => void;
}

export interface Computing extends Running {
  /** The largest number of threads, if threads are available; by default one for each core. */
  threads?: number;
}

/** Repairs that make a mesh acceptable. */
export interface Remedies {
  triangulate?: boolean;
  repair?: boolean;
  /** A length, or a percentage of the diagonal of the bounding box: joins points of open edges that are closer. */
  weld?: number | string;
}

export type Point = [number, number, number];

export interface Loop {
  length: number | null;
  component: number;
  bounds: 'inside' | 'outside' | 'neither' | 'undecided';
  /** [u, v, t]: on the edge from vertex u to vertex v, at the fraction t of it. */
  locations: [number, number, number][];
  /** Three coordinates for each point; the first is not repeated at the end. */
  points: Float64Array;
}

export interface Ball {
  diameter: number;
  error: number;
  /** The center of the ball where it has the least room. */
  throat: Point;
  /** The path of the center of the ball. */
  curve: Point[];
}

export interface Pair {
  /** The length of the shorter loop over the diagonal of the bounding box of the mesh. */
  size: number | null;
  centre: Point;
  box: [Point, Point];
  diameter?: number | null;
  diameter_of?: 'bore' | 'hole';
  out_of_roundness?: number | null;
  wall_diameter?: number | null;
  bore?: {
    diameter: number;
    centre: Point;
    axis: Point;
    depth: number;
    deviation: number;
    drilling: number;
  };
  /** With `measure`: the thickness of the handle, and the clear width of its hole. */
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
  /** The number of threads used. */
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
  removal?: boolean;
}

/** The handle and tunnel loops, in pairs, with their certificate. */
export function loops(mesh: MeshLike, options?: LoopsOptions): Promise<Loops>;

/** The same with the thickness of each handle and the clear width of its hole. */
export function measure(mesh: MeshLike, options?: LoopsOptions): Promise<Loops>;

export interface ReebGraph {
  mesh: MeshFacts;
  capped: boolean;
  cycles: number;
  nodes: { id: number; type: 'minimum' | 'saddle' | 'maximum' | 'regular'; vertex: number; value: number; position: Point }[];
  arcs: { id: number; source: number; target: number; vertex_count: number; length: number; girth: number; polyline: Float64Array }[];
  vertex_arc: number[];
}

export interface ReebOptions extends Computing, Remedies {
  /** Use the height in this direction instead of a diffusion. */
  height?: Point;
  /** Vertices to diffuse from. */
  seed?: number[];
  simplify?: number;
  shortestArc?: number;
  /** Close boundary curves by caps first; otherwise contours end at the boundary. */
  capped?: boolean;
  drawing?: 'inside' | 'means';
}

export function reebGraph(mesh: MeshLike, options?: ReebOptions): Promise<ReebGraph>;

export interface Skeleton {
  mesh: MeshFacts;
  cycles: number;
  certificate: { connected: boolean; inside: boolean; embedded: boolean; cycles: boolean; failure: string; taken_alone: string };
  nodes: { id: number; position: Point; radius: number; kind: string; component: number }[];
  arcs: { arc: number; component: number; length: number; source: number; target: number; polyline: Point[]; radii: number[] }[];
  vertex_point: number[];
}

/** A curve skeleton, with a certificate that it lies inside. */
export function skeleton(mesh: MeshLike, options?: Computing & Remedies & { shortestLimb?: number }): Promise<Skeleton>;

export interface Changed {
  mesh: Mesh;
  report: Record<string, unknown>;
}

/** Lengths are numbers, or percentages of the diagonal of the bounding box, such as '3%'. One way to select is required. */
export interface RemoveOptions extends Computing, Remedies {
  all?: boolean;
  genus?: number;
  shorterThan?: number | string;
  noiseBelow?: number | string;
  /** Numbers of pairs, as in the result of `loops`. */
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

/** Makes a closed solid where it can justify the changes; the report lists what is left. */
export function clean(mesh: MeshLike, options?: CleanOptions): Promise<Changed>;

/** The mesh cut open along short arcs of edges, so that each component is a disk. */
export function cut(mesh: MeshLike, options?: Computing & Remedies & { through?: number[]; cutSpheres?: boolean }): Promise<{ mesh: Mesh }>;

/** A test mesh of known genus: 'torus', 'multi-torus', 'gyroid', 'lattice', ... */
export function generate(kind: string, options?: { faces?: number; genus?: number; seed?: number; signal?: AbortSignal; [option: string]: unknown }): Promise<Mesh>;

export interface RunOptions extends Running {
  /** Files that the run can read, by name. The arrays are copied. */
  files?: Record<string, Uint8Array>;
  /** Names of files to return. */
  outputs?: string[];
  /** Standard input. */
  input?: Uint8Array;
  /** Called with each line of the messages. */
  onText?: (line: string) => void;
}

export interface RunResult {
  exitCode: number;
  files: Record<string, Uint8Array>;
  /** Standard output. */
  output: Uint8Array;
  messages: string;
}

/** Runs the command `htloops` with these arguments, on files in memory. */
export function run(args: string[], options?: RunOptions): Promise<RunResult>;

/** The message of the tool, with the exit code: 1 no certified answer, 2 wrong usage, 3 a mesh that cannot be read,
 * 4 a mesh that is not accepted; null if the run failed otherwise. */
export class HtloopsError extends Error {
  exitCode: number | null;
  messages: string;
}
