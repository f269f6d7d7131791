package org.robotui.rtps;

/** What a reader gets that comes late. What is later in this list offers more. */
public enum Durability {
  /** Nothing of what was written before it came. */
  VOLATILE,
  /** What the writer keeps, for as long as the writer lives. */
  TRANSIENT_LOCAL,
  /** What a service keeps, also when the writer is gone. */
  TRANSIENT,
  /** What a service keeps on a disk. */
  PERSISTENT
}
