package org.robotui.script.internal.engine;

import java.time.Duration;

/**
 * What a script may take.
 *
 * @param computing how long without waiting
 * @param heap whether there is memory left
 */
record ScriptLimits(Duration computing, HeapLook heap) {
  static final ScriptLimits USUAL = new ScriptLimits(Duration.ofSeconds(10), new HeapLook());

  /** How many calls of functions of a script may lie within each other. */
  static final int DEPTH = 1000;
  /** How long a text may become at one stroke, characters. */
  static final int LONGEST_TEXT = 16 << 20;
  /** How many values may be handed over at a time. */
  static final int MOST_VALUES = 1_000_000;
  /** How deep values may lie within each other that are handed over. */
  static final int NESTING = 50;
}
