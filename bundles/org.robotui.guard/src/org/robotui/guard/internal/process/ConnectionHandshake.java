package org.robotui.guard.internal.process;

import java.io.IOException;
import java.net.InetAddress;
import java.net.InetSocketAddress;
import java.nio.BufferUnderflowException;
import java.nio.ByteBuffer;
import java.nio.channels.SelectionKey;
import java.nio.channels.Selector;
import java.nio.channels.SocketChannel;
import java.nio.charset.StandardCharsets;
import java.security.MessageDigest;
import java.time.Duration;
import java.util.Arrays;
import org.robotui.guard.internal.wire.Wire;

/**
 * A connection whose greeting has to come, and then that to the robot it asks for. Any program of this machine may try:
 * only ours knows the secret.
 */
final class ConnectionHandshake implements Handler {
  private static final Duration PATIENCE = Duration.ofSeconds(2);
  private static final int MOST = Wire.SECRET + 1 + 16 + 2 + 4;
  private static final int MOST_REASON = 300;

  /** Takes over a robot that is reached. */
  interface Reached {
    Handler stream(SelectionKey near, SelectionKey far);
  }

  private final SelectionKey near;
  private final byte[] knock;
  private final byte[] answer;
  private final Reached reached;
  private final ByteBuffer said = ByteBuffer.allocate(MOST);
  private long deadline;
  private SocketChannel far;

  private ConnectionHandshake(SelectionKey near, byte[] knock, byte[] answer, Reached reached) {
    this.near = near;
    this.knock = knock;
    this.answer = answer;
    this.reached = reached;
    this.deadline = System.nanoTime() + PATIENCE.toNanos();
  }

  /** Waits for the greeting of a new connection. */
  static void on(SelectionKey near, byte[] knock, byte[] answer, Reached reached) {
    near.attach(new ConnectionHandshake(near, knock, answer, reached));
  }

  @Override
  public void ready(SelectionKey key) throws IOException {
    if (key == near) {
      read();
    } else {
      finish(key);
    }
  }

  /** Byte by byte where the greeting's length is not known yet: what follows it is the robot's. */
  private void read() throws IOException {
    while (far == null) {
      said.limit(wanted());
      if (((SocketChannel) near.channel()).read(said) < 0) {
        throw new IOException("no greeting");
      }
      if (said.hasRemaining()) {
        return;
      }
      if (said.position() == Wire.SECRET && !MessageDigest.isEqual(knock, Arrays.copyOf(said.array(), Wire.SECRET))) {
        throw new IOException("a stranger");
      }
      if (said.position() > Wire.SECRET + 1) {
        connect();
      }
    }
  }

  private int wanted() throws IOException {
    if (said.position() < Wire.SECRET) {
      return Wire.SECRET;
    }
    int start = Wire.SECRET + 1;
    return said.position() < start ? start : start + Orders.length(said.get(Wire.SECRET) & 0xff) + 2 + 4;
  }

  private void connect() throws IOException {
    said.flip().position(Wire.SECRET);
    byte[] address = new byte[said.get()];
    int port;
    int millis;
    try {
      said.get(address);
      port = said.getShort() & 0xffff;
      millis = said.getInt();
    } catch (BufferUnderflowException e) {
      throw new IOException("a greeting that is too short", e);
    }
    near.interestOps(0);
    deadline = System.nanoTime() + Duration.ofMillis(Math.clamp(millis, 1, 60_000)).toNanos();
    far = Channels.toRobot();
    try {
      SelectionKey key = far.register(selector(), SelectionKey.OP_CONNECT, this);
      if (far.connect(new InetSocketAddress(InetAddress.getByAddress(address), port))) {
        finish(key);
      }
    } catch (IOException | RuntimeException e) {
      refuse(e);
    }
  }

  private Selector selector() {
    return near.selector();
  }

  private void finish(SelectionKey key) throws IOException {
    try {
      far.finishConnect();
    } catch (IOException e) {
      refuse(e);
      return;
    }
    reply(ByteBuffer.allocate(Wire.SECRET + 1).put(answer).put((byte) Wire.DONE).flip());
    reached.stream(near, key);
  }

  private void refuse(Exception cause) throws IOException {
    byte[] text = String.valueOf(cause.getMessage()).getBytes(StandardCharsets.UTF_8);
    int length = Math.min(text.length, MOST_REASON);
    reply(ByteBuffer.allocate(Wire.SECRET + 3 + length).put(answer).put((byte) Wire.REFUSED).putShort((short) length)
        .put(text, 0, length).flip());
    close();
  }

  /** A new connection has room for it. */
  private void reply(ByteBuffer bytes) throws IOException {
    ((SocketChannel) near.channel()).write(bytes);
    if (bytes.hasRemaining()) {
      throw new IOException("the answer is not taken");
    }
  }

  @Override
  public void tick(long now) throws IOException {
    if (now - deadline > 0) {
      if (far == null) {
        close();
      } else {
        refuse(new IOException("timed out"));
      }
    }
  }

  @Override
  public void close() {
    Channels.quietly(near.channel());
    if (far != null) {
      Channels.quietly(far);
    }
  }
}
