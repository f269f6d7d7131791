package org.robotui.rtps.internal.wire;

import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.util.HexFormat;
import java.util.Optional;
import org.robotui.rtps.Guid;
import org.robotui.rtps.SampleIdentity;

/**
 * What stands beside a sample, as far as this library knows it.
 *
 * @param disposed whether its instance is no more
 * @param unregistered whether its writer says no more of the instance
 * @param related the sample that it answers
 * @param key the sixteen bytes that stand for its instance: for built-in topics, the GUID of whom it is about
 */
public record InlineQos(boolean disposed, boolean unregistered, Optional<SampleIdentity> related,
    Optional<Guid> key) {

  /** Nothing is said. */
  public static final InlineQos NONE = new InlineQos(false, false, Optional.empty(), Optional.empty());

  private static final int DISPOSED = 1;

  private static final int UNREGISTERED = 2;

  /**
   * Reads it.
   *
   * @param list a parameter list in the byte order of the buffer, which stays as it is; may be empty
   * @return what it says
   * @throws WireException if it is none
   */
  public static InlineQos read(ByteBuffer list) throws WireException {
    if (!list.hasRemaining()) {
      return NONE;
    }
    int status = 0;
    Optional<SampleIdentity> related = Optional.empty();
    Optional<Guid> key = Optional.empty();
    ParameterInput parameters = new ParameterInput(list.duplicate().order(list.order()));
    while (parameters.next()) {
      ByteBuffer value = parameters.value();
      switch (parameters.id()) {
        case ParameterId.STATUS_INFO -> status = ParameterValue.number(value.order(ByteOrder.BIG_ENDIAN));
        case ParameterId.KEY_HASH -> key = Optional.of(WireInput.guid(value));
        case ParameterId.RELATED_SAMPLE, ParameterId.RELATED_SAMPLE_OLD -> related = Optional.of(identity(value));
        default -> {
          // the QoS of the writer is known by discovery; the rest is not used
        }
      }
    }
    return new InlineQos((status & DISPOSED) != 0, (status & UNREGISTERED) != 0, related, key);
  }

  /** Requests name the reader of their replies in this way, with a number that is none: it is taken as it is. */
  private static SampleIdentity identity(ByteBuffer value) throws WireException {
    WireInput.need(value, Guid.BYTES + 8, "a sample identity");
    Guid writer = WireInput.guid(value);
    return new SampleIdentity(writer, (long) value.getInt() << 32 | Integer.toUnsignedLong(value.getInt()));
  }

  /**
   * Writes it.
   *
   * @param order the byte order
   * @return a parameter list; empty where nothing is said
   */
  public ByteBuffer bytes(ByteOrder order) {
    if (equals(NONE)) {
      return ByteBuffer.allocate(0).order(order);
    }
    ParameterOutput out = new ParameterOutput(order);
    related.ifPresent(sample -> {
      out.sample(ParameterId.RELATED_SAMPLE_OLD, sample.writer(), sample.sequence());
      out.sample(ParameterId.RELATED_SAMPLE, sample.writer(), sample.sequence());
    });
    key.ifPresent(guid -> out.guid(ParameterId.KEY_HASH, guid));
    int status = (disposed ? DISPOSED : 0) | (unregistered ? UNREGISTERED : 0);
    if (status != 0) {
      out.plain(ParameterId.STATUS_INFO, HexFormat.of().parseHex("0000000" + status));
    }
    return out.finish();
  }
}
