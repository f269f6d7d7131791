package org.robotui.yarp.internal;

import java.io.Closeable;
import java.io.IOException;
import java.net.InetAddress;
import java.net.InetSocketAddress;
import java.net.NetworkInterface;
import java.net.StandardProtocolFamily;
import java.net.StandardSocketOptions;
import java.nio.ByteBuffer;
import java.nio.channels.DatagramChannel;
import java.util.Optional;
import java.util.function.Consumer;
import org.robotui.net.log.PeerText;
import org.robotui.net.socket.Sockets;
import org.robotui.yarp.wire.YarpMessage;

/** Takes the messages of one sender by udp or mcast, after its handshake. */
final class DatagramInput implements Closeable {
  private static final int RECEIVE_BUFFER = 1 << 22;
  private static final int LARGEST = 1 << 16;

  private final DatagramChannel channel;
  private final Optional<InetAddress> only;
  private final DatagramAssembly assembly = new DatagramAssembly();

  private DatagramInput(DatagramChannel channel, Optional<InetAddress> only) {
    this.channel = channel;
    this.only = only;
  }

  /** A free port of an address of ours, which takes nothing but what comes from the sender's machine. */
  static DatagramInput alone(InetAddress own, InetAddress sender) throws IOException {
    return open(new InetSocketAddress(own, 0), Optional.of(sender), channel -> {});
  }

  /** A group, by the network interface that has the address; whoever sends to the group is heard. */
  static DatagramInput group(InetSocketAddress group, InetAddress own) throws IOException {
    NetworkInterface over = NetworkInterface.getByInetAddress(own);
    if (!group.getAddress().isMulticastAddress() || over == null) {
      throw new IOException(group + " is no group that can be listened to by " + own.getHostAddress());
    }
    // bound to the group, so that nothing else that is sent to the port gets in
    return open(group, Optional.empty(), channel -> channel.join(group.getAddress(), over));
  }

  private interface Joining {
    void join(DatagramChannel channel) throws IOException;
  }

  private static DatagramInput open(InetSocketAddress at, Optional<InetAddress> only, Joining joining)
      throws IOException {
    DatagramChannel channel = DatagramChannel.open(StandardProtocolFamily.INET);
    try {
      channel.setOption(StandardSocketOptions.SO_REUSEADDR, at.getPort() != 0);
      channel.setOption(StandardSocketOptions.SO_RCVBUF, RECEIVE_BUFFER);
      channel.bind(at);
      joining.join(channel);
      return new DatagramInput(channel, only);
    } catch (IOException | RuntimeException e) {
      Sockets.closeQuietly(channel);
      throw e;
    }
  }

  int port() throws IOException {
    return ((InetSocketAddress) channel.getLocalAddress()).getPort();
  }

  /** Receives until it is closed, or a message ends it; says why it ended. */
  String receive(Consumer<YarpMessage> messages, Consumer<String> lost) {
    ByteBuffer room = ByteBuffer.allocate(LARGEST);
    try {
      while (true) {
        InetSocketAddress from = (InetSocketAddress) channel.receive(room.clear());
        if (only.isPresent() && !only.get().equals(from.getAddress())) {
          continue;
        }
        DatagramAssembly.Taken taken = assembly.take(room.flip());
        taken.lost().ifPresent(lost);
        taken.message().ifPresent(messages);
        if (taken.message().filter(message -> message.command().equals("q")).isPresent()) {
          return "it was closed";
        }
      }
    } catch (IOException e) {
      return channel.isOpen() ? PeerText.brief(String.valueOf(e.getMessage())) : "it was closed";
    }
  }

  @Override
  public void close() {
    Sockets.closeQuietly(channel);
  }
}
