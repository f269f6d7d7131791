package org.robotui.lcm.internal.udpm;

import java.io.Closeable;
import java.io.IOException;
import java.net.InetSocketAddress;
import java.net.NetworkInterface;
import java.net.StandardProtocolFamily;
import java.net.StandardSocketOptions;
import java.nio.ByteBuffer;
import java.nio.channels.DatagramChannel;

/** Sends messages, in fragments where they are long. */
final class UdpmSender implements Closeable {

  private static final int SEND_BUFFER = 4 << 20;

  private final DatagramChannel out;
  private int sequence;

  private UdpmSender(DatagramChannel out) {
    this.out = out;
  }

  static UdpmSender open(InetSocketAddress group, NetworkInterface over, int ttl) throws IOException {
    DatagramChannel out = DatagramChannel.open(StandardProtocolFamily.INET);
    try {
      out.setOption(StandardSocketOptions.IP_MULTICAST_IF, over);
      out.setOption(StandardSocketOptions.IP_MULTICAST_TTL, ttl);
      out.setOption(StandardSocketOptions.SO_SNDBUF, SEND_BUFFER);
      out.connect(group);
      return new UdpmSender(out);
    } catch (IOException | RuntimeException e) {
      out.close();
      throw e;
    }
  }

  /** One message at a time, so that the fragments of two never mix. */
  synchronized void publish(byte[] channel, ByteBuffer data) throws IOException {
    long size = channel.length + 1L + data.remaining();
    if (size <= Wire.MOST_SHORT) {
      ByteBuffer header =
          ByteBuffer.allocate(Wire.SHORT_HEADER + channel.length + 1).putInt(Wire.SHORT).putInt(sequence);
      send(header.put(channel).put((byte) 0), data);
    } else {
      fragments(channel, data, size);
    }
    sequence++;
  }

  private void fragments(byte[] channel, ByteBuffer data, long size) throws IOException {
    long count = (size + Wire.MOST_FRAGMENT - 1) / Wire.MOST_FRAGMENT;
    if (count > Wire.MOST_FRAGMENTS) {
      throw new IOException("it needs " + count + " fragments, and " + Wire.MOST_FRAGMENTS + " are possible");
    }
    int start = data.position();
    int total = data.remaining();
    int end = data.limit();
    for (int number = 0; number < count; number++) {
      byte[] name = number == 0 ? channel : new byte[0];
      int named = number == 0 ? channel.length + 1 : 0;
      ByteBuffer header = ByteBuffer.allocate(Wire.FRAGMENT_HEADER + named).putInt(Wire.FRAGMENT).putInt(sequence)
          .putInt(total).putInt(data.position() - start).putShort((short) number).putShort((short) count).put(name);
      data.limit(Math.min(end, data.position() + Wire.MOST_FRAGMENT - named));
      send(header.position(header.limit()), data);
      data.limit(end);
    }
  }

  private void send(ByteBuffer header, ByteBuffer data) throws IOException {
    out.write(new ByteBuffer[]{header.flip(), data});
  }

  @Override
  public void close() throws IOException {
    out.close();
  }
}
