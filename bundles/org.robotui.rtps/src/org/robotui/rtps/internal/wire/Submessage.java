package org.robotui.rtps.internal.wire;

import java.nio.ByteBuffer;
import java.util.List;
import org.robotui.rtps.EntityId;
import org.robotui.rtps.GuidPrefix;
import org.robotui.rtps.Locator;
import org.robotui.rtps.ProtocolVersion;
import org.robotui.rtps.VendorId;

/** A part of a message. Sequence numbers are from 1 on, fragments are counted from 1. */
public sealed interface Submessage {

  /** One that a reader and a writer exchange. Either may be {@link EntityId#UNKNOWN}: all that fit. */
  sealed interface Exchanged extends Submessage {

    /** The reader that it is for or from. */
    EntityId reader();

    /** The writer that it is from or for. */
    EntityId writer();
  }

  /** What the payload of a sample is. */
  enum Content {
    /** There is none: all is said by the inline QoS. */
    NOTHING,
    /** The whole sample. */
    SAMPLE,
    /** The key of its instance. */
    KEY
  }

  /**
   * A sample.
   *
   * @param inlineQos a parameter list with its end, in the byte order of the buffer; see {@link InlineQos}; may be
   * empty
   * @param payload from its encapsulation header on; up to three bytes of padding may follow
   */
  record Data(EntityId reader, EntityId writer, long sequence, ByteBuffer inlineQos, Content content,
      ByteBuffer payload) implements Exchanged {}

  /**
   * Neighbouring fragments of a sample.
   *
   * @param first the number of the first one
   * @param count how many they are, at least 1
   * @param fragmentSize of each but the last one of the sample
   * @param sampleSize bytes of the whole sample
   * @param inlineQos as in {@link Data}
   * @param key whether the sample is but the key of its instance
   * @param payload exactly the bytes of these fragments
   */
  record DataFrag(EntityId reader, EntityId writer, long sequence, long first, int count, int fragmentSize,
      long sampleSize, ByteBuffer inlineQos, boolean key, ByteBuffer payload) implements Exchanged {}

  /**
   * Which samples a writer has.
   *
   * @param first the oldest one
   * @param last the newest one; {@code first - 1} if there is none
   * @param count rises with each; what does not is old
   * @param finalFlag whether no answer is needed
   * @param liveliness whether it also says that its application is alive
   */
  record Heartbeat(EntityId reader, EntityId writer, long first, long last, int count, boolean finalFlag,
      boolean liveliness) implements Exchanged {}

  /** Which fragments of a sample a writer has: all up to the last one. */
  record HeartbeatFrag(EntityId reader, EntityId writer, long sequence, long last, int count) implements Exchanged {}

  /**
   * What a reader has, all before the base, and what it lacks.
   *
   * @param finalFlag whether no heartbeat is asked for
   */
  record AckNack(EntityId reader, EntityId writer, SequenceSet missing, int count,
      boolean finalFlag) implements Exchanged {}

  /** Which fragments of a sample a reader lacks. */
  record NackFrag(EntityId reader, EntityId writer, long sequence, SequenceSet missing,
      int count) implements Exchanged {}

  /** Numbers that never come: from the start to before the base of the set, and those in it. */
  record Gap(EntityId reader, EntityId writer, long start, SequenceSet set) implements Exchanged {}

  /** When the samples that follow were written: nanoseconds since 1970, or {@link WireTime#NONE}. */
  record InfoTimestamp(long nanos) implements Submessage {}

  /** For whom what follows is; {@link GuidPrefix#UNKNOWN} for all. */
  record InfoDestination(GuidPrefix prefix) implements Submessage {}

  /** From whom what follows is. */
  record InfoSource(ProtocolVersion version, VendorId vendor, GuidPrefix prefix) implements Submessage {}

  /** Where answers to what follows are to go. */
  record InfoReply(List<Locator> unicast, List<Locator> multicast) implements Submessage {

    /** Copies the lists. */
    public InfoReply {
      unicast = List.copyOf(unicast);
      multicast = List.copyOf(multicast);
    }
  }
}
