package org.robotui.gl.internal.gpu;

import java.util.EnumMap;
import java.util.Map;

/** Counts what one context holds on the graphics card. Read by any thread. */
public final class Ledger {
  /** What is counted. */
  public enum Kind {
    /** Vertices and indices. */
    BUFFER,
    /** How vertices lie in buffers. */
    VERTEX_ARRAY,
    /** Pictures. */
    TEXTURE,
    /** What is drawn into. */
    FRAMEBUFFER,
    /** Pixels of framebuffers. */
    RENDERBUFFER,
    /** Shaders. */
    PROGRAM
  }

  private final Map<Kind, Integer> held = new EnumMap<>(Kind.class);
  private long bytes;

  synchronized void made(Kind kind) {
    held.merge(kind, 1, Integer::sum);
  }

  synchronized void freed(Kind kind) {
    held.merge(kind, -1, Integer::sum);
  }

  synchronized void grew(long by) {
    bytes += by;
  }

  /**
   * How many there are of a kind.
   *
   * @param kind what
   * @return how many
   */
  public synchronized int held(Kind kind) {
    return held.getOrDefault(kind, 0);
  }

  /**
   * The bytes of all buffers, textures and renderbuffers.
   *
   * @return bytes
   */
  public synchronized long bytes() {
    return bytes;
  }
}
