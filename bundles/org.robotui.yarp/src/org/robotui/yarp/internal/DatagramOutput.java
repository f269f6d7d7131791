package org.robotui.yarp.internal;

import java.io.Closeable;
import java.io.IOException;
import java.io.InputStream;
import java.net.InetAddress;
import java.net.InetSocketAddress;
import java.net.NetworkInterface;
import java.net.Socket;
import java.net.StandardProtocolFamily;
import java.net.StandardSocketOptions;
import java.nio.ByteBuffer;
import java.nio.channels.DatagramChannel;
import java.util.Optional;
import org.robotui.net.socket.Sockets;
import org.robotui.yarp.wire.YarpFraming;
import org.robotui.yarp.wire.YarpMessage;

/** Says messages by udp or mcast, after a handshake. */
public final class DatagramOutput implements Closeable {
  private static final int SEND_BUFFER = 1 << 18;
  private static final int LAST_PORT = 0xffff;

  private final DatagramChannel channel;

  private DatagramOutput(DatagramChannel channel) {
    this.channel = channel;
  }

  /**
   * After the header was written: to a group that is named to the receiver, else to the port that it answers with.
   */
  public static DatagramOutput open(Socket socket, InputStream in, Optional<InetSocketAddress> group)
      throws IOException {
    if (group.isPresent()) {
      byte[] address = group.get().getAddress().getAddress();
      socket.getOutputStream().write(ByteBuffer.allocate(YarpFraming.GROUP).put(address)
          .putShort((short) group.get().getPort()).array());
      return open(group.get(), Optional.of(socket.getLocalAddress()));
    }
    int port = YarpFraming.readMark(in);
    if (port < 1 || port > LAST_PORT) {
      throw new IOException(socket.getRemoteSocketAddress() + " takes no datagrams");
    }
    return open(new InetSocketAddress(socket.getInetAddress(), port), Optional.empty());
  }

  private static DatagramOutput open(InetSocketAddress to, Optional<InetAddress> over) throws IOException {
    DatagramChannel channel = DatagramChannel.open(StandardProtocolFamily.INET);
    try {
      channel.setOption(StandardSocketOptions.SO_SNDBUF, SEND_BUFFER);
      if (over.isPresent()) {
        channel.setOption(StandardSocketOptions.IP_MULTICAST_IF, NetworkInterface.getByInetAddress(over.get()));
      }
      channel.connect(to);
      return new DatagramOutput(channel);
    } catch (IOException | RuntimeException e) {
      Sockets.closeQuietly(channel);
      throw e;
    }
  }

  public void send(YarpMessage message) throws IOException {
    for (byte[] piece : DatagramPieces.split(YarpFraming.bytes(message), DatagramPieces.LONGEST)) {
      channel.write(ByteBuffer.wrap(piece));
    }
  }

  @Override
  public void close() {
    Sockets.closeQuietly(channel);
  }
}
