package org.robotui.rtps.internal.wire;

import java.util.List;
import org.robotui.rtps.GuidPrefix;
import org.robotui.rtps.Locator;
import org.robotui.rtps.ProtocolVersion;
import org.robotui.rtps.VendorId;

/** What the earlier parts of a message say about the later ones. It changes from part to part: keep what it gives. */
public final class MessageContext {

  private ProtocolVersion version = ProtocolVersion.V2_3;

  private VendorId vendor = VendorId.UNKNOWN;

  private GuidPrefix source = GuidPrefix.UNKNOWN;

  private GuidPrefix destination = GuidPrefix.UNKNOWN;

  private long timestamp = WireTime.NONE;

  private List<Locator> reply = List.of();

  void begin(ProtocolVersion spoken, VendorId maker, GuidPrefix sender) {
    version = spoken;
    vendor = maker;
    source = sender;
    destination = GuidPrefix.UNKNOWN;
    timestamp = WireTime.NONE;
    reply = List.of();
  }

  void apply(Submessage info) {
    switch (info) {
      case Submessage.InfoTimestamp time -> timestamp = time.nanos();
      case Submessage.InfoDestination to -> destination = to.prefix();
      case Submessage.InfoSource from -> begin(from.version(), from.vendor(), from.prefix());
      case Submessage.InfoReply where -> reply = where.unicast();
      case Submessage.Exchanged ignored -> throw new IllegalArgumentException("not about others: " + ignored);
    }
  }

  /** Which version the sender speaks. */
  public ProtocolVersion version() {
    return version;
  }

  /** Who made the sender's library. */
  public VendorId vendor() {
    return vendor;
  }

  /** Who sent it. */
  public GuidPrefix source() {
    return source;
  }

  /** For whom it is; {@link GuidPrefix#UNKNOWN} for all. */
  public GuidPrefix destination() {
    return destination;
  }

  /** When the sample was written, in nanoseconds since 1970, or {@link WireTime#NONE}. */
  public long timestamp() {
    return timestamp;
  }

  /** Where answers are to go; empty: as usual. */
  public List<Locator> reply() {
    return reply;
  }
}
