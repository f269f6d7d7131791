package org.robotui.api.record;

/** How recordings are made smaller. */
public enum RecordingPacking {
  /** Not at all. */
  NONE,
  /** Fast. */
  LZ4,
  /** Smaller than LZ4, and slower. */
  ZSTD
}
