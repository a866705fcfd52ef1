/** Samples of a volume, x fastest, then y, then z. */
export type Samples = Uint8Array | Int8Array | Uint16Array | Int16Array | Uint32Array | Int32Array |
  BigUint64Array | BigInt64Array | Float32Array | Float64Array;

/** Three numbers along x, y and z. */
export type Triple = [number, number, number];

/** A closed mesh without T-junctions. */
export interface Mesh {
  /** Three coordinates per vertex. Units: those of the spacing. */
  positions: Float32Array;
  /** Three numbers of vertices per triangle, counter-clockwise seen from outside. */
  triangles: Uint32Array;
  /** Three coordinates of a unit vector per vertex, outwards; only if the surface is relaxed or interpolated. */
  normals?: Float32Array;
}

export interface DecodedMeshOptions {
  /**
   * Where the vertices lie. polygons (default): in the middles between voxels. relaxed: on a smooth surface that keeps
   * every voxel on its side. interpolated: where the fractions of the stream have them. Limit: StreamState.levels.
   */
  surface?: 'polygons' | 'relaxed' | 'interpolated';
}

export interface ExtractOptions {
  /** Distances between voxels; negative if an axis runs backwards. Default: 1. */
  spacing?: Triple;
  /** Whether every voxel becomes the majority of the 3 x 3 x 3 around it first. */
  filter?: boolean;
}

/** What arrived of a stream, and what is missing. */
export interface StreamState {
  hasHeader: boolean;
  dims: Triple;
  /** Units: millimetres; 1 if the stream has none. */
  spacing: Triple;
  threshold: number;
  polygons: number;
  isComplete: boolean;
  hasTrailer: boolean;
  lostPackets: number;
  damagedPackets: number;
  /** Rows of a stream of slices, else regions and fragments. */
  lostPieces: number;
  holdsSlices: boolean;
  /** The levels of the fractions in a stream of slices; 0 if it has none. */
  levels: number;
  bytes: number;
}

/** Decodes one scan of a link. Any bytes are safe. */
export interface Decoder {
  /** Accepts any number of bytes. Throws for a stream of an unknown version. */
  push(bytes: Uint8Array): void;
  /** No bytes follow. */
  finish(): StreamState;
  readonly state: StreamState;
  /**
   * The triangles of the polygons that arrived so far. Throws RangeError if the stream has no fractions to interpolate.
   */
  mesh(options?: DecodedMeshOptions): Mesh;
}

export interface Discmc {
  /**
   * The surface around the voxels whose samples are >= iso. dims: at most 16,383 each.
   * Throws TypeError and RangeError with the value and the remedy.
   */
  extract(samples: Samples, dims: Triple, iso: number, options?: ExtractOptions):
    Mesh & { polygons: number };
  /** choice: a scan and a channel of the link; default: the first that arrive. */
  decoder(choice?: { scan: number; channel: number }): Promise<Decoder>;
}

/** Loads the WebAssembly module. wasm: its bytes; default: discmc.wasm beside index.js. */
export function load(options?: { wasm?: BufferSource }): Promise<Discmc>;
