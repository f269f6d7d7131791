package org.robotui.rtps.internal.wire;

import java.nio.ByteBuffer;
import org.robotui.rtps.EntityId;

/** Reads the submessages that readers and writers exchange. */
final class PartReader {

  private static final ByteBuffer EMPTY = ByteBuffer.allocate(0).asReadOnlyBuffer();

  /** From behind the offset to the inline QoS: reader, writer, sequence number. */
  private static final int DATA_FIXED = 16;

  /** And number, count and size of fragments, and size of the sample. */
  private static final int FRAG_FIXED = 28;

  private PartReader() {}

  static Submessage.Exchanged read(int id, int flags, ByteBuffer in) throws WireException {
    return switch (id) {
      case SubmessageId.DATA -> data(flags, in);
      case SubmessageId.DATA_FRAG -> dataFrag(flags, in);
      case SubmessageId.HEARTBEAT -> heartbeat(flags, in);
      case SubmessageId.HEARTBEAT_FRAG -> new Submessage.HeartbeatFrag(WireInput.entity(in), WireInput.entity(in),
          WireInput.sequence(in), WireInput.unsigned(in), count(in));
      case SubmessageId.ACKNACK -> new Submessage.AckNack(WireInput.entity(in), WireInput.entity(in),
          WireInput.sequenceSet(in), count(in), (flags & SubmessageId.FINAL) != 0);
      case SubmessageId.NACK_FRAG -> new Submessage.NackFrag(WireInput.entity(in), WireInput.entity(in),
          WireInput.sequence(in), WireInput.fragmentSet(in), count(in));
      case SubmessageId.GAP -> gap(in);
      default -> throw new WireException("is not exchanged by readers and writers");
    };
  }

  private static int count(ByteBuffer in) throws WireException {
    return (int) WireInput.unsigned(in);
  }

  private static Submessage.Exchanged data(int flags, ByteBuffer in) throws WireException {
    int behind = start(in, DATA_FIXED);
    EntityId reader = WireInput.entity(in);
    EntityId writer = WireInput.entity(in);
    long sequence = WireInput.sequence(in);
    in.position(behind);
    ByteBuffer qos = inlineQos(flags, in);
    Submessage.Content content = content(flags);
    ByteBuffer payload = content == Submessage.Content.NOTHING ? EMPTY : in.slice();
    return new Submessage.Data(reader, writer, sequence, qos, content, payload);
  }

  private static Submessage.Content content(int flags) throws WireException {
    if ((flags & SubmessageId.NOT_STANDARD) != 0) {
      throw new WireException("a payload that is no standard one");
    }
    boolean key = (flags & SubmessageId.KEY) != 0;
    if ((flags & SubmessageId.SAMPLE) == 0) {
      return key ? Submessage.Content.KEY : Submessage.Content.NOTHING;
    }
    if (key) {
      throw new WireException("a payload that is a sample and a key");
    }
    return Submessage.Content.SAMPLE;
  }

  /** Where the inline QoS or the payload begins: later versions may put more before it. */
  private static int start(ByteBuffer in, int fixed) throws WireException {
    WireInput.need(in, 4 + fixed, "the fixed part");
    in.getShort(); // more flags, of which there are none yet
    int offset = Short.toUnsignedInt(in.getShort());
    if (offset < fixed || offset > in.remaining()) {
      throw new WireException("inline QoS at %d, of %d to %d".formatted(offset, fixed, in.remaining()));
    }
    return in.position() + offset;
  }

  private static ByteBuffer inlineQos(int flags, ByteBuffer in) throws WireException {
    if ((flags & SubmessageId.INLINE_QOS) == 0) {
      return EMPTY;
    }
    int start = in.position();
    ParameterInput.skip(in);
    return in.slice(start, in.position() - start).order(in.order());
  }

  private static Submessage.Exchanged dataFrag(int flags, ByteBuffer in) throws WireException {
    if ((flags & SubmessageId.FRAG_NOT_STANDARD) != 0) {
      throw new WireException("a payload that is no standard one");
    }
    int behind = start(in, FRAG_FIXED);
    EntityId reader = WireInput.entity(in);
    EntityId writer = WireInput.entity(in);
    long sequence = WireInput.sequence(in);
    long first = WireInput.unsigned(in);
    int count = Short.toUnsignedInt(in.getShort());
    int size = Short.toUnsignedInt(in.getShort());
    long sampleSize = WireInput.unsigned(in);
    in.position(behind);
    ByteBuffer qos = inlineQos(flags, in);
    int bytes = fragmentBytes(first, count, size, sampleSize, in.remaining());
    return new Submessage.DataFrag(reader, writer, sequence, first, count, size, sampleSize, qos,
        (flags & SubmessageId.FRAG_KEY) != 0, in.slice(in.position(), bytes));
  }

  private static int fragmentBytes(long first, int count, int size, long sampleSize, int here) throws WireException {
    long before = (first - 1) * size;
    long bytes = Math.min((long) count * size, sampleSize - before);
    if (first < 1 || count < 1 || size < 1 || bytes <= (count - 1L) * size || bytes > here) {
      throw new WireException("%d fragments of %d bytes from %d on, of a sample of %d bytes, in %d bytes"
          .formatted(count, size, first, sampleSize, here));
    }
    return (int) bytes;
  }

  private static Submessage.Exchanged heartbeat(int flags, ByteBuffer in) throws WireException {
    EntityId reader = WireInput.entity(in);
    EntityId writer = WireInput.entity(in);
    long first = WireInput.sequence(in);
    long last = WireInput.number(in);
    if (last < first - 1) {
      throw new WireException("samples from " + first + " to " + last);
    }
    return new Submessage.Heartbeat(reader, writer, first, last, count(in), (flags & SubmessageId.FINAL) != 0,
        (flags & SubmessageId.LIVELINESS) != 0);
  }

  private static Submessage.Exchanged gap(ByteBuffer in) throws WireException {
    EntityId reader = WireInput.entity(in);
    EntityId writer = WireInput.entity(in);
    long start = WireInput.sequence(in);
    SequenceSet set = WireInput.sequenceSet(in);
    if (set.base() < start) {
      throw new WireException("a gap from " + start + " to " + set.base());
    }
    return new Submessage.Gap(reader, writer, start, set);
  }
}
