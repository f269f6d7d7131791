package org.robotui.guard.internal.process;

import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.channels.SelectionKey;
import java.nio.channels.SocketChannel;
import java.time.Duration;
import java.util.Optional;
import java.util.function.BooleanSupplier;
import java.util.function.Consumer;

/**
 * One connection between the guarded process (near) and a robot (far). What the robot sends is always read, into a
 * bounded memory; what we send is read no faster than the robot takes it, since commands must not wait here.
 */
final class Stream implements Handler {
  private static final int UP = 4 * 1024;
  /** For last words on a connection that is being closed. */
  private static final Duration LAST = Duration.ofSeconds(1);

  private final SelectionKey near;
  private final SelectionKey far;
  private final Backlog down;
  private final ByteBuffer up = ByteBuffer.allocate(UP).flip();
  private final Duration mayBeFull;
  private final BooleanSupplier late;
  private final Consumer<Stream> overflow;
  private boolean farEnded;
  private Optional<Long> nearEnded = Optional.empty();
  private Optional<Long> full = Optional.empty();

  Stream(SelectionKey near, SelectionKey far, Backlog down, Duration mayBeFull, BooleanSupplier late,
      Consumer<Stream> overflow) {
    this.near = near;
    this.far = far;
    this.down = down;
    this.mayBeFull = mayBeFull;
    this.late = late;
    this.overflow = overflow;
    near.attach(this);
    far.attach(this);
    settle();
  }

  String where() throws IOException {
    return nearEnded.isPresent() ? "closing" : String.valueOf(farChannel().getRemoteAddress());
  }

  long waiting() {
    return down.bytes();
  }

  private SocketChannel nearChannel() {
    return (SocketChannel) near.channel();
  }

  private SocketChannel farChannel() {
    return (SocketChannel) far.channel();
  }

  @Override
  public void ready(SelectionKey key) throws IOException {
    if (key == far && key.isReadable()) {
      receive();
    }
    if (!down.isEmpty() && nearEnded.isEmpty()) {
      down.writeTo(nearChannel());
    }
    send(key == near && key.isReadable());
    if (isOver()) {
      close();
    } else {
      settle();
    }
  }

  private void receive() throws IOException {
    Optional<Integer> count = down.readFrom(farChannel());
    farEnded = count.filter(c -> c < 0).isPresent();
    if (count.isEmpty() && full.isEmpty()) {
      full = Optional.of(System.nanoTime());
    }
    if (nearEnded.isPresent()) {
      down.drop();
    }
  }

  private void send(boolean more) throws IOException {
    if (more && !up.hasRemaining()) {
      int count = nearChannel().read(up.clear());
      up.flip();
      if (count < 0) {
        nearEnded = Optional.of(System.nanoTime());
      }
    }
    if (up.hasRemaining()) {
      farChannel().write(up);
    }
  }

  private boolean isOver() {
    return nearEnded.isPresent() && !up.hasRemaining() || farEnded && down.isEmpty();
  }

  private void settle() {
    if (full.isPresent() && !down.isHalfFull() && down.hasRoom()) {
      full = Optional.empty();
    }
    boolean reads = !farEnded && full.isEmpty();
    far.interestOps((reads ? SelectionKey.OP_READ : 0) | (up.hasRemaining() ? SelectionKey.OP_WRITE : 0));
    near.interestOps((up.hasRemaining() || nearEnded.isPresent() ? 0 : SelectionKey.OP_READ)
        | (down.isEmpty() || nearEnded.isPresent() ? 0 : SelectionKey.OP_WRITE));
  }

  /** Ends what holds the robot up for too long, and last words that nobody takes. */
  @Override
  public void tick(long now) {
    boolean slow = full.filter(since -> late.getAsBoolean() || now - since > mayBeFull.toNanos()).isPresent();
    if (slow && nearEnded.isEmpty()) {
      overflow.accept(this);
      close();
    } else if (nearEnded.filter(since -> now - since > LAST.toNanos()).isPresent()) {
      close();
    } else if (full.isPresent()) {
      settle(); // others may have given memory back
    }
  }

  @Override
  public void close() {
    Channels.quietly(far.channel());
    Channels.quietly(near.channel());
    down.drop();
  }
}
