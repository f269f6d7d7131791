package org.robotui.rtps.internal.wire;

import java.nio.ByteBuffer;
import org.robotui.rtps.EntityId;

/** Writes what stands behind the headers of submessages. */
final class PartWriter {

  private PartWriter() {}

  static int id(Submessage part) {
    return switch (part) {
      case Submessage.Data ignored -> SubmessageId.DATA;
      case Submessage.DataFrag ignored -> SubmessageId.DATA_FRAG;
      case Submessage.Heartbeat ignored -> SubmessageId.HEARTBEAT;
      case Submessage.HeartbeatFrag ignored -> SubmessageId.HEARTBEAT_FRAG;
      case Submessage.AckNack ignored -> SubmessageId.ACKNACK;
      case Submessage.NackFrag ignored -> SubmessageId.NACK_FRAG;
      case Submessage.Gap ignored -> SubmessageId.GAP;
      case Submessage.InfoTimestamp ignored -> SubmessageId.INFO_TS;
      case Submessage.InfoDestination ignored -> SubmessageId.INFO_DST;
      case Submessage.InfoSource ignored -> SubmessageId.INFO_SRC;
      case Submessage.InfoReply ignored -> SubmessageId.INFO_REPLY;
    };
  }

  /** Gives the flags. */
  static int write(Submessage part, ByteBuffer out) {
    return switch (part) {
      case Submessage.Exchanged exchanged -> exchanged(exchanged, out);
      case Submessage.InfoTimestamp time -> timestamp(time, out);
      case Submessage.InfoDestination to -> {
        WireOutput.prefix(out, to.prefix());
        yield 0;
      }
      case Submessage.InfoSource from -> {
        out.putInt(0).put((byte) from.version().major()).put((byte) from.version().minor());
        WireOutput.pair(out, from.vendor().value());
        WireOutput.prefix(out, from.prefix());
        yield 0;
      }
      case Submessage.InfoReply where -> reply(where, out);
    };
  }

  private static int timestamp(Submessage.InfoTimestamp time, ByteBuffer out) {
    if (time.nanos() == WireTime.NONE) {
      return SubmessageId.NO_TIME;
    }
    out.putInt(WireTime.seconds(time.nanos())).putInt(WireTime.fraction(time.nanos()));
    return 0;
  }

  private static int reply(Submessage.InfoReply where, ByteBuffer out) {
    WireOutput.locators(out, where.unicast());
    if (where.multicast().isEmpty()) {
      return 0;
    }
    WireOutput.locators(out, where.multicast());
    return SubmessageId.MULTICAST;
  }

  private static int exchanged(Submessage.Exchanged part, ByteBuffer out) {
    return switch (part) {
      case Submessage.Data data -> data(data, out);
      case Submessage.DataFrag frag -> dataFrag(frag, out);
      case Submessage.Heartbeat beat -> heartbeat(beat, out);
      case Submessage.HeartbeatFrag beat -> {
        ends(beat.reader(), beat.writer(), beat.sequence(), out).putInt((int) beat.last()).putInt(beat.count());
        yield 0;
      }
      case Submessage.AckNack ack -> acknack(ack, out);
      case Submessage.NackFrag nack -> {
        ends(nack.reader(), nack.writer(), nack.sequence(), out);
        WireOutput.fragmentSet(out, nack.missing());
        out.putInt(nack.count());
        yield 0;
      }
      case Submessage.Gap gap -> {
        ends(gap.reader(), gap.writer(), gap.start(), out);
        WireOutput.sequenceSet(out, gap.set());
        yield 0;
      }
    };
  }

  private static ByteBuffer ends(EntityId reader, EntityId writer, long sequence, ByteBuffer out) {
    WireOutput.entity(out, reader);
    WireOutput.entity(out, writer);
    WireOutput.sequence(out, sequence);
    return out;
  }

  private static int data(Submessage.Data data, ByteBuffer out) {
    out.putShort((short) 0).putShort((short) 16);
    ends(data.reader(), data.writer(), data.sequence(), out);
    int flags = inlineQos(data.inlineQos(), out) | switch (data.content()) {
      case NOTHING -> 0;
      case SAMPLE -> SubmessageId.SAMPLE;
      case KEY -> SubmessageId.KEY;
    };
    payload(data.payload(), out);
    return flags;
  }

  private static int dataFrag(Submessage.DataFrag frag, ByteBuffer out) {
    out.putShort((short) 0).putShort((short) 28);
    ends(frag.reader(), frag.writer(), frag.sequence(), out);
    out.putInt((int) frag.first()).putShort((short) frag.count()).putShort((short) frag.fragmentSize());
    out.putInt((int) frag.sampleSize());
    int flags = inlineQos(frag.inlineQos(), out) | (frag.key() ? SubmessageId.FRAG_KEY : 0);
    payload(frag.payload(), out);
    return flags;
  }

  private static int inlineQos(ByteBuffer qos, ByteBuffer out) {
    if (!qos.hasRemaining()) {
      return 0;
    }
    if (qos.order() != out.order()) {
      throw new IllegalArgumentException("inline QoS of the other byte order");
    }
    out.put(qos.duplicate());
    return SubmessageId.INLINE_QOS;
  }

  private static void payload(ByteBuffer payload, ByteBuffer out) {
    int start = out.position();
    out.put(payload.duplicate());
    WireOutput.align(out, start);
  }

  private static int heartbeat(Submessage.Heartbeat beat, ByteBuffer out) {
    ends(beat.reader(), beat.writer(), beat.first(), out);
    WireOutput.sequence(out, beat.last());
    out.putInt(beat.count());
    return (beat.finalFlag() ? SubmessageId.FINAL : 0) | (beat.liveliness() ? SubmessageId.LIVELINESS : 0);
  }

  private static int acknack(Submessage.AckNack ack, ByteBuffer out) {
    WireOutput.entity(out, ack.reader());
    WireOutput.entity(out, ack.writer());
    WireOutput.sequenceSet(out, ack.missing());
    out.putInt(ack.count());
    return ack.finalFlag() ? SubmessageId.FINAL : 0;
  }
}
