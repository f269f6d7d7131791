package org.robotui.player.wire;

import java.io.EOFException;
import java.io.IOException;
import java.io.InputStream;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.charset.StandardCharsets;
import java.util.Arrays;
import java.util.function.Supplier;

/** Messages and the server's greeting as bytes of a stream. */
public final class Framing {

  private static final String GREETING = "Player v.";
  private static final int AT_ONCE = 1 << 18;

  private Framing() {}

  /**
   * Reads the greeting that a server sends first.
   *
   * @param in the stream
   * @return the server's version, such as {@code 3.1.1-dev}
   * @throws IOException if the stream fails or ends
   * @throws PlayerException if it is another greeting
   */
  public static String readBanner(InputStream in) throws IOException, PlayerException {
    byte[] bytes = exactly(in, PlayerMessage.BANNER_BYTES, () -> "the greeting");
    int end = 0;
    while (end < bytes.length && bytes[end] >= ' ' && bytes[end] < 0x7f) {
      end++;
    }
    String text = new String(bytes, 0, end, StandardCharsets.US_ASCII);
    if (!text.startsWith(GREETING)) {
      throw new PlayerException("the peer is no Player server: it greets with '" + text + "'");
    }
    return text.substring(GREETING.length());
  }

  /**
   * The greeting of a server.
   *
   * @param version its version; what is longer than 22 characters is cut
   * @return 32 bytes
   */
  public static ByteBuffer banner(String version) {
    byte[] text = (GREETING + version).getBytes(StandardCharsets.US_ASCII);
    ByteBuffer banner = ByteBuffer.allocate(PlayerMessage.BANNER_BYTES);
    return banner.put(text, 0, Math.min(text.length, PlayerMessage.BANNER_BYTES - 1)).rewind().asReadOnlyBuffer();
  }

  /**
   * Reads one message.
   *
   * @param in the stream
   * @return the message
   * @throws EOFException if the stream ends, also between two messages
   * @throws IOException if the stream fails
   * @throws PlayerException if the header is none; the stream is of no use after that
   */
  public static PlayerMessage read(InputStream in) throws IOException, PlayerException {
    XdrReader xdr = new XdrReader(ByteBuffer.wrap(exactly(in, PlayerMessage.HEADER_BYTES, () -> "a header")));
    try {
      int host = xdr.i32();
      DeviceAddress device = new DeviceAddress(host, xdr.i32(), xdr.within(0, 0xffff), xdr.within(0, 0xffff));
      int code = xdr.i32();
      MessageType type =
          MessageType.of(code).orElseThrow(() -> new PlayerException("there is no message type " + code));
      int subtype = xdr.within(0, 0xff);
      double stamp = xdr.f64();
      long sequence = xdr.u32();
      return new PlayerMessage(device, type, subtype, stamp, sequence, ByteBuffer.wrap(body(xdr.u32(), device, in)));
    } catch (PlayerException e) {
      throw e.within("header of a message");
    }
  }

  private static byte[] body(long size, DeviceAddress device, InputStream in) throws IOException, PlayerException {
    if (size > PlayerMessage.MAX_BYTES - PlayerMessage.HEADER_BYTES) {
      throw new PlayerException(
          "a message of " + size + " bytes from device " + device + " is longer than Player's messages can be");
    }
    return exactly(in, (int) size, () -> "a message of device " + device);
  }

  /**
   * Writes one message.
   *
   * @param message the message
   * @return header and body, big endian, position 0
   */
  public static ByteBuffer bytes(PlayerMessage message) {
    ByteBuffer payload = message.payload();
    ByteBuffer out = ByteBuffer.allocate(PlayerMessage.HEADER_BYTES + payload.remaining()).order(ByteOrder.BIG_ENDIAN);
    DeviceAddress device = message.device();
    out.putInt(device.host()).putInt(device.robot()).putInt(device.interfaceCode()).putInt(device.index());
    out.putInt(message.type().code()).putInt(message.subtype());
    out.putLong(Double.doubleToRawLongBits(message.stamp())).putInt((int) message.sequence());
    return out.putInt(payload.remaining()).put(payload).flip();
  }

  /** Reads as the bytes come: what a peer only announces takes little memory. */
  private static byte[] exactly(InputStream in, int size, Supplier<String> what) throws IOException {
    byte[] bytes = new byte[Math.min(size, AT_ONCE)];
    int came = 0;
    while (came < size) {
      if (came == bytes.length) {
        bytes = Arrays.copyOf(bytes, (int) Math.min(size, 2L * came));
      }
      int more = in.read(bytes, came, bytes.length - came);
      if (more < 0) {
        throw new EOFException(came == 0 ? "the peer closed the connection"
            : "the peer closed the connection after " + came + " of " + size + " bytes of " + what.get());
      }
      came += more;
    }
    return bytes;
  }
}
