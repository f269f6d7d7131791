package org.robotui.recorder.internal.capture;

import java.nio.ByteBuffer;
import java.util.Optional;

/**
 * A message on its way into a file.
 *
 * @param head what it has in common with others
 * @param logTime when it was received, nanoseconds since 1970
 * @param publishTime when it was sent, by the clock of its robot; the log time where that is not known
 * @param sequence its number
 * @param bytes it
 * @param holder who said what holds until the same says something else; none where it does not hold
 */
public record Captured(StreamHead head, long logTime, long publishTime, long sequence, ByteBuffer bytes,
    Optional<String> holder) {
  /** What else it takes in memory, about. */
  private static final int OVERHEAD = 200;

  /** How much memory it takes, about. */
  public int weight() {
    return bytes.remaining() + OVERHEAD;
  }

  /** The same, said anew. */
  public Captured at(long time) {
    return new Captured(head, time, publishTime, sequence, bytes, holder);
  }
}
