package org.robotui.rtps.internal.wire;

import java.nio.ByteBuffer;
import java.util.List;
import org.robotui.rtps.Locator;
import org.robotui.rtps.ProtocolVersion;
import org.robotui.rtps.VendorId;

/** Reads the submessages that say something about those which follow. */
final class InfoReader {

  private InfoReader() {}

  static Submessage read(int id, int flags, ByteBuffer in) throws WireException {
    boolean multicast = (flags & SubmessageId.MULTICAST) != 0;
    return switch (id) {
      case SubmessageId.INFO_TS -> timestamp((flags & SubmessageId.NO_TIME) != 0, in);
      case SubmessageId.INFO_DST -> new Submessage.InfoDestination(WireInput.prefix(in));
      case SubmessageId.INFO_SRC -> source(in);
      case SubmessageId.INFO_REPLY -> new Submessage.InfoReply(WireInput.locators(in),
          multicast ? WireInput.locators(in) : List.<Locator>of());
      case SubmessageId.INFO_REPLY_IP4 -> new Submessage.InfoReply(List.of(WireInput.locatorIp4(in)),
          multicast ? List.of(WireInput.locatorIp4(in)) : List.<Locator>of());
      default -> throw new WireException("tells nothing about others");
    };
  }

  private static Submessage timestamp(boolean none, ByteBuffer in) throws WireException {
    if (none) {
      return new Submessage.InfoTimestamp(WireTime.NONE);
    }
    WireInput.need(in, 8, "a time");
    return new Submessage.InfoTimestamp(WireTime.nanos(in.getInt(), in.getInt()));
  }

  private static Submessage source(ByteBuffer in) throws WireException {
    WireInput.need(in, 8, "a source");
    in.getInt(); // unused
    ProtocolVersion version = new ProtocolVersion(Byte.toUnsignedInt(in.get()), Byte.toUnsignedInt(in.get()));
    int high = Byte.toUnsignedInt(in.get());
    VendorId vendor = new VendorId(high << 8 | Byte.toUnsignedInt(in.get()));
    return new Submessage.InfoSource(version, vendor, WireInput.prefix(in));
  }
}
