package org.robotui.rtps.internal.wire;

/** How many bytes submessages take, with their headers. */
final class SubmessageSize {

  private static final int HEADER = 4;

  private static final int LOCATOR = 24;

  private SubmessageSize() {}

  static int of(Submessage part) {
    return HEADER + switch (part) {
      case Submessage.Data data -> 20 + data.inlineQos().remaining() + aligned(data.payload().remaining());
      case Submessage.DataFrag frag -> 32 + frag.inlineQos().remaining() + aligned(frag.payload().remaining());
      case Submessage.Heartbeat ignored -> 28;
      case Submessage.HeartbeatFrag ignored -> 24;
      case Submessage.AckNack ack -> 24 + 4 * ack.missing().words().length;
      case Submessage.NackFrag nack -> 28 + 4 * nack.missing().words().length;
      case Submessage.Gap gap -> 28 + 4 * gap.set().words().length;
      case Submessage.InfoTimestamp time -> time.nanos() == WireTime.NONE ? 0 : 8;
      case Submessage.InfoDestination ignored -> 12;
      case Submessage.InfoSource ignored -> 20;
      case Submessage.InfoReply reply -> locators(reply.unicast().size())
          + (reply.multicast().isEmpty() ? 0 : locators(reply.multicast().size()));
    };
  }

  private static int aligned(int bytes) {
    return bytes + 3 & ~3;
  }

  private static int locators(int count) {
    return 4 + LOCATOR * count;
  }
}
