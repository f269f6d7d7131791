package org.robotui.data;

/** What becomes of values that a consumer has not yet taken when the next one arrives. */
public enum Conflation {
  /** The newest wins: only the present matters (a scan, an image). */
  SAMPLE,
  /** The newest per key wins; see {@link Keyed} (transforms, joint states); the number of keys is bounded. */
  KEYED,
  /** Each one counts: queued, and counted as dropped when the bounded queue is full (a log entry). */
  EVENT
}
