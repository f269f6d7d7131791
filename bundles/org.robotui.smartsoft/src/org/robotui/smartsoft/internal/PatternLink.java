package org.robotui.smartsoft.internal;

import java.io.Closeable;
import java.io.IOException;
import java.net.Socket;
import java.time.Duration;
import java.util.Optional;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.ExecutionException;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.TimeoutException;
import java.util.concurrent.atomic.AtomicReference;
import org.robotui.message.CdrReader;
import org.robotui.message.MessageException;
import org.robotui.net.link.FrameLink;
import org.robotui.net.socket.Sockets;
import org.robotui.net.thread.Workers;
import org.robotui.smartsoft.wire.LinkOptions;
import org.robotui.smartsoft.naming.ServiceAddress;
import org.robotui.smartsoft.wire.SmartCommand;
import org.robotui.smartsoft.wire.SmartFrame;
import org.robotui.smartsoft.wire.SmartFraming;

/** A connection of a client to a service that has been taken. */
public final class PatternLink implements Closeable {

  /** Takes what a server says, on the reading thread. */
  public interface Listener {

    /** A message that has to do with the pattern; what it throws ends the link. */
    void said(SmartCommand command, SmartFrame frame) throws IOException;

    /** The connection has ended; told once, not of one that never began. */
    void ended(String reason);
  }

  private static final Duration END = Duration.ofMillis(500);
  private static final int CLIENT = 1;

  private final ServiceAddress address;
  private final Listener listener;
  private final Workers workers;
  private final FrameLink<SmartFrame> link;
  private final CompletableFuture<Integer> taken = new CompletableFuture<>();
  private final AtomicReference<Optional<String>> over = new AtomicReference<>(Optional.empty());

  private PatternLink(ServiceAddress address, LinkOptions options, Socket socket, Listener listener)
      throws IOException {
    this.address = address;
    this.listener = listener;
    this.workers = new Workers(options.threads());
    this.link = new FrameLink<>(socket, new SmartFraming(), new FromServer());
  }

  /** Connects and waits until the server takes it; blocks. */
  public static PatternLink connect(ServiceAddress address, LinkOptions options, Listener listener)
      throws IOException {
    Socket socket = options.sockets().createSocket();
    try {
      Sockets.minimizeSendBuffer(socket);
      address.at().connect(socket, options.patience());
      Sockets.prepare(socket);
      PatternLink made = new PatternLink(address, options, socket, listener);
      made.begin(options.patience());
      return made;
    } catch (IOException | RuntimeException e) {
      Sockets.closeQuietly(socket);
      throw e;
    }
  }

  private void begin(Duration patience) throws IOException {
    link.start(workers, "smartsoft service " + address.at());
    link.send(SmartFrame.of(SmartCommand.CONNECT, PatternData.of().i32(CLIENT).string(address.identifier()).end()));
    try {
      int status = taken.get(patience.toNanos(), TimeUnit.NANOSECONDS);
      if (status != SmartStatus.OK) {
        throw new IOException(address.at() + " does not take us: " + SmartStatus.text(status));
      }
    } catch (TimeoutException e) {
      throw failed("it did not answer in time", e);
    } catch (ExecutionException e) {
      throw failed(e.getCause().getMessage(), e);
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
      throw failed("connecting was given up", e);
    }
  }

  private IOException failed(String reason, Exception cause) {
    link.finish();
    return new IOException(address.at() + ": " + reason, cause);
  }

  private final class FromServer implements FrameLink.Receiver<SmartFrame> {
    @Override
    public void received(SmartFrame frame, FrameLink<SmartFrame> from) throws IOException {
      Optional<SmartCommand> command = SmartCommand.of(frame.command());
      if (command.isEmpty()) {
        throw new IOException("nothing is known of the command " + frame.command());
      }
      switch (command.get()) {
        case ACK_CONNECT -> {
          try {
            CdrReader said = frame.reader();
            said.int32("client");
            taken.complete(said.int32("status"));
          } catch (MessageException e) {
            throw new IOException(e.getMessage(), e);
          }
        }
        case SERVER_INITIATED_DISCONNECT -> throw new IOException("the service was ended");
        case ACK_DISCONNECT -> {}
        default -> listener.said(command.get(), frame);
      }
    }

    @Override
    public void ended(FrameLink<SmartFrame> from, String reason) {
      boolean began = taken.isDone() && !taken.isCompletedExceptionally();
      over.compareAndSet(Optional.empty(), Optional.of(address.at() + ": " + reason));
      taken.completeExceptionally(new IOException(reason));
      if (began) {
        listener.ended(reason);
      }
    }
  }

  /** Sends a message in its turn; false where the link has ended. */
  public boolean send(SmartFrame frame) {
    return link.send(frame);
  }

  /** Sends a message in place of an older one of its kind that still waits. */
  public boolean replace(String kind, SmartFrame frame) {
    return link.replace(kind, frame);
  }

  /** Why it has ended; empty while it has not. */
  public Optional<String> over() {
    return over.get();
  }

  /** Says goodbye; does not block. */
  public void finish() {
    link.send(SmartFrame.of(SmartCommand.DISCONNECT));
    link.finish();
  }

  /** Says goodbye where the server still takes it, and ends; bounded. */
  @Override
  public void close() {
    finish();
    link.close();
    workers.join(System.nanoTime() + END.toNanos());
  }
}
