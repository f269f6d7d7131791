package org.robotui.smartsoft.internal;

import org.robotui.message.CdrWriter;
import org.robotui.smartsoft.wire.SmartFrame;

/** Writes what patterns say. */
public final class PatternData {

  private final CdrWriter out = SmartFrame.data();

  private PatternData() {}

  /** Nothing yet. */
  public static PatternData of() {
    return new PatternData();
  }

  /** A number of 32 bits. */
  public PatternData i32(int value) {
    out.i32(value);
    return this;
  }

  /** A number of 64 bits. */
  public PatternData i64(long value) {
    out.i64(value);
    return this;
  }

  /** A text. */
  public PatternData string(String value) {
    out.string(value);
    return this;
  }

  /** All of it. */
  public CdrWriter end() {
    return out;
  }
}
