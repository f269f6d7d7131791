package org.robotui.rtps;

import java.nio.ByteBuffer;
import java.util.Optional;

/**
 * A sample as a reader took it from the network.
 *
 * @param payload its bytes from the encapsulation header (4 bytes) on, read-only; nobody else writes them, so that they
 * may be kept. Empty where the writer only says which instance ended
 * @param kind whether it is data, or says that an instance ended
 * @param writer who wrote it
 * @param sequence the writer's number of it, from 1 on
 * @param sourceNanos when it was written by the clock of the writer, in nanoseconds since 1970, or {@link #NO_TIME}
 * @param related the sample that this one answers, as replies of services say it
 * @param received when it was complete, as {@link System#nanoTime}
 */
public record Sample(ByteBuffer payload, Kind kind, Guid writer, long sequence, long sourceNanos,
    Optional<SampleIdentity> related, long received) {

  /** The source time of a sample whose writer did not say when it was written. */
  public static final long NO_TIME = Long.MIN_VALUE;

  /** What a sample says of its instance. */
  public enum Kind {
    /** There is data. */
    ALIVE,
    /** The instance is no more. */
    DISPOSED,
    /** The writer will say no more of the instance. */
    UNREGISTERED
  }

  /**
   * The bytes.
   *
   * @return a view of its own for each call
   */
  @Override
  public ByteBuffer payload() {
    return payload.duplicate();
  }

  /**
   * Which sample this is, to be named as the related one of an answer.
   *
   * @return writer and number
   */
  public SampleIdentity identity() {
    return new SampleIdentity(writer, sequence);
  }
}
