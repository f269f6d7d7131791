package org.robotui.lcm.internal.udpm;

import java.io.IOException;
import java.net.InetSocketAddress;
import java.net.NetworkInterface;
import java.net.StandardProtocolFamily;
import java.net.StandardSocketOptions;
import java.nio.ByteBuffer;
import java.nio.channels.DatagramChannel;
import java.time.Duration;
import org.robotui.lcm.LcmOptions;
import org.robotui.lcm.internal.client.Inlet;
import org.robotui.lcm.internal.client.Link;
import org.robotui.net.thread.Workers;

/**
 * The sockets of one multicast group: one that receives, and one that sends, whose port tells this sender from all
 * others.
 */
final class UdpmLink implements Link {

  private static final Duration ENDING = Duration.ofMillis(500);

  /** So many times what the kernel is asked for waits outside of it, where the kernel often grants less. */
  private static final long KEPT_BUFFERS = 2;

  private final DatagramChannel in;
  private final UdpmSender sender;
  private final Inbox inbox;
  private final Backlog backlog;
  private final Gate gate;
  private final Workers workers;
  private final String where;

  private UdpmLink(DatagramChannel in, UdpmSender sender, Inbox inbox, Backlog backlog, Workers workers, String where) {
    this.in = in;
    this.sender = sender;
    this.inbox = inbox;
    this.backlog = backlog;
    this.gate = new Gate(backlog.free());
    this.workers = workers;
    this.where = where;
  }

  static UdpmLink open(InetSocketAddress group, NetworkInterface over, int ttl, int receiveBuffer, LcmOptions options,
      Inlet inlet)
      throws IOException {
    DatagramChannel in = DatagramChannel.open(StandardProtocolFamily.INET);
    try {
      in.setOption(StandardSocketOptions.SO_REUSEADDR, true);
      in.setOption(StandardSocketOptions.SO_RCVBUF, receiveBuffer);
      // bound to the group, so that nothing else that is sent to the port gets in
      in.bind(group);
      in.join(group.getAddress(), over);
      int granted = in.getOption(StandardSocketOptions.SO_RCVBUF);
      String where = "%s:%d on %s, ttl %d, receive buffer %d of %d bytes".formatted(group.getAddress().getHostAddress(),
          group.getPort(),
          over.getName(), ttl, granted, receiveBuffer);
      return new UdpmLink(in, UdpmSender.open(group, over, ttl), new Inbox(inlet, options),
          new Backlog(KEPT_BUFFERS * receiveBuffer), new Workers(options.threads()), where);
    } catch (IOException | RuntimeException e) {
      in.close();
      throw e;
    }
  }

  /** What the kernel granted, in bytes. */
  int receiveBuffer() throws IOException {
    return in.getOption(StandardSocketOptions.SO_RCVBUF);
  }

  @Override
  public String where() {
    return where;
  }

  @Override
  public String receive() throws IOException {
    workers.start("LCM socket of " + where, this::fill);
    try {
      while (true) {
        Backlog.Entry datagram = backlog.take();
        inbox.accept(datagram.from(), datagram.bytes(), datagram.received());
        backlog.done(datagram);
      }
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
      throw new IOException("interrupted", e);
    } finally {
      in.close();
      backlog.discard();
      workers.join(System.nanoTime() + ENDING.toNanos());
    }
  }

  /** The work of the thread that empties the kernel's buffer. */
  private void fill() {
    try {
      while (true) {
        ByteBuffer room = backlog.room();
        InetSocketAddress from = (InetSocketAddress) in.receive(room);
        long now = System.nanoTime();
        if (gate.admits(from, room.duplicate().flip(), backlog.free(), now)) {
          backlog.add(from, room, now);
        }
      }
    } catch (IOException e) {
      backlog.end(e);
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
      backlog.end(new IOException("interrupted", e));
    } catch (RuntimeException | OutOfMemoryError e) {
      backlog.end(new IOException("datagrams cannot be received: " + e, e));
    }
  }

  @Override
  public void publish(byte[] channel, ByteBuffer data) throws IOException {
    sender.publish(channel, data);
  }

  @Override
  public void tidy() {
    inbox.expire(System.nanoTime());
  }

  @Override
  public void close() throws IOException {
    try {
      in.close();
    } finally {
      backlog.discard();
      sender.close();
    }
  }
}
