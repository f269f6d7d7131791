package org.robotui.rtps.internal.wire;

import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import org.robotui.rtps.GuidPrefix;
import org.robotui.rtps.ProtocolVersion;
import org.robotui.rtps.VendorId;

/**
 * Reads messages: their header, what is said about their parts, and the parts that are for one participant. What this
 * library does not know is skipped. For one thread.
 */
public final class DatagramReader {

  /** The shortest message. */
  public static final int HEADER_BYTES = 20;

  private static final int MAGIC = 0x52545053;

  private static final int SUBMESSAGE_HEADER = 4;

  private final GuidPrefix own;

  private final MessageContext context = new MessageContext();

  /**
   * Reads for a participant.
   *
   * @param own which one; what it sent itself and what is for others is skipped
   */
  public DatagramReader(GuidPrefix own) {
    this.own = own;
  }

  /**
   * Reads a message.
   *
   * @param datagram from position to limit; afterwards its position is anywhere
   * @param handler takes the parts, in their order
   * @throws WireException at the first part that is none, as nobody knows what follows; those before it were taken
   */
  public void read(ByteBuffer datagram, MessageHandler handler) throws WireException {
    int start = datagram.position();
    header(datagram);
    while (datagram.remaining() >= SUBMESSAGE_HEADER) {
      int at = datagram.position() - start;
      int id = Byte.toUnsignedInt(datagram.get());
      int flags = Byte.toUnsignedInt(datagram.get());
      datagram.order((flags & SubmessageId.LITTLE) != 0 ? ByteOrder.LITTLE_ENDIAN : ByteOrder.BIG_ENDIAN);
      ByteBuffer body = body(datagram, id, at);
      try {
        part(id, flags, body, handler);
      } catch (WireException e) {
        throw new WireException("%s at byte %d: %s".formatted(SubmessageId.name(id), at, e.getMessage()));
      }
    }
  }

  /**
   * Who sent a message, by its header. Good from the header on, also where the rest is no message.
   *
   * @return what is known of the message that is or was read last
   */
  public MessageContext context() {
    return context;
  }

  private void header(ByteBuffer in) throws WireException {
    in.order(ByteOrder.BIG_ENDIAN);
    context.begin(ProtocolVersion.V2_3, VendorId.UNKNOWN, GuidPrefix.UNKNOWN);
    if (in.remaining() < HEADER_BYTES || in.getInt() != MAGIC) {
      throw new WireException("no RTPS message");
    }
    int major = Byte.toUnsignedInt(in.get());
    int minor = Byte.toUnsignedInt(in.get());
    if (major != ProtocolVersion.V2_3.major()) {
      throw new WireException("RTPS version " + major + "." + minor);
    }
    VendorId vendor = new VendorId(Short.toUnsignedInt(in.getShort()));
    context.begin(new ProtocolVersion(major, minor), vendor, WireInput.prefix(in));
  }

  /** A length of zero reaches to the end of the message, but for the two that may have no content. */
  private static ByteBuffer body(ByteBuffer in, int id, int at) throws WireException {
    int length = Short.toUnsignedInt(in.getShort());
    if (length == 0 && id != SubmessageId.PAD && id != SubmessageId.INFO_TS) {
      length = in.remaining();
    }
    if (length > in.remaining()) {
      throw new WireException("%s at byte %d has %d bytes, here are %d".formatted(SubmessageId.name(id), at, length,
          in.remaining()));
    }
    ByteBuffer body = in.slice(in.position(), length).order(in.order());
    in.position(in.position() + length);
    return body;
  }

  private void part(int id, int flags, ByteBuffer body, MessageHandler handler) throws WireException {
    switch (id) {
      case SubmessageId.INFO_TS, SubmessageId.INFO_DST, SubmessageId.INFO_SRC, SubmessageId.INFO_REPLY,
          SubmessageId.INFO_REPLY_IP4 -> context.apply(InfoReader.read(id, flags, body));
      case SubmessageId.DATA, SubmessageId.DATA_FRAG, SubmessageId.HEARTBEAT, SubmessageId.HEARTBEAT_FRAG,
          SubmessageId.ACKNACK, SubmessageId.NACK_FRAG, SubmessageId.GAP -> {
        if (forUs()) {
          handler.onPart(context, PartReader.read(id, flags, body));
        }
      }
      default -> {
        // padding, and what vendors or later versions add
      }
    }
  }

  private boolean forUs() {
    GuidPrefix to = context.destination();
    return !context.source().equals(own) && (to.equals(own) || to.equals(GuidPrefix.UNKNOWN));
  }
}
