package org.robotui.net.link;

import java.io.Closeable;
import java.io.IOException;
import java.net.Socket;
import java.time.Duration;
import java.util.ArrayDeque;
import java.util.LinkedHashMap;
import java.util.Map;
import java.util.concurrent.CountDownLatch;
import java.util.concurrent.TimeUnit;
import org.robotui.net.log.PeerText;
import org.robotui.net.socket.DeadlineInput;
import org.robotui.net.socket.Sockets;
import org.robotui.net.thread.Workers;

/**
 * A connection that carries frames: one thread reads, one writes what waits. Sending never blocks. Commands replace
 * older ones of their kind that still wait, and go before all else, so that a stop does not wait behind questions. Safe
 * for all threads.
 *
 * @param <F> a frame
 */
public final class FrameLink<F> implements Closeable {

  /**
   * Takes what comes, on the reading thread; must not block.
   *
   * @param <F> a frame
   */
  public interface Receiver<F> {

    /**
     * A frame has come.
     *
     * @param frame the frame
     * @param link on which it came
     * @throws IOException where it cannot be used, which ends the link
     */
    void received(F frame, FrameLink<F> link) throws IOException;

    /**
     * The link has ended; told once.
     *
     * @param link that has ended
     * @param reason for users
     */
    void ended(FrameLink<F> link, String reason);
  }

  private static final int BUFFER = 1 << 16;
  private static final int MOST_FRAMES = 2048;
  private static final long MOST_BYTES = 1 << 25;
  private static final Duration REST_OF_FRAME = Duration.ofSeconds(10);
  private static final long FLUSH_NANOS = Duration.ofMillis(400).toNanos();

  private final Socket socket;
  private final DeadlineInput in;
  private final Framing<F> framing;
  private final Receiver<F> receiver;
  private final ArrayDeque<byte[]> waiting = new ArrayDeque<>(); // guarded by this, as the following
  private final Map<String, byte[]> newest = new LinkedHashMap<>();
  private long waitingBytes;
  private boolean finishing;
  private boolean ended;
  private long finishingSince;
  private final CountDownLatch flushed = new CountDownLatch(1);

  /**
   * Of a socket that is connected.
   *
   * @param socket is closed with the link
   * @param framing how frames become bytes
   * @param receiver takes what comes
   * @throws IOException where the socket is closed
   */
  public FrameLink(Socket socket, Framing<F> framing, Receiver<F> receiver) throws IOException {
    this.socket = socket;
    this.framing = framing;
    this.receiver = receiver;
    this.in = new DeadlineInput(socket, BUFFER);
  }

  /**
   * Its input, before {@link #start}.
   *
   * @return where a greeting can be read
   */
  public DeadlineInput input() {
    return in;
  }

  /**
   * Begins to read and write.
   *
   * @param workers start both threads
   * @param name of the threads
   */
  public void start(Workers workers, String name) {
    workers.start(name + " from", this::read);
    workers.start(name + " to", this::write);
  }

  private void read() {
    String reason;
    try {
      while (true) {
        in.nextMessage(REST_OF_FRAME);
        receiver.received(framing.read(in), this);
      }
    } catch (IOException e) {
      reason = PeerText.brief(String.valueOf(e.getMessage()));
    } catch (IllegalArgumentException | ArithmeticException e) {
      reason = "what came cannot be used: " + PeerText.brief(String.valueOf(e.getMessage()));
    }
    end(reason);
  }

  private void write() {
    try {
      for (byte[] next = take(); next.length > 0; next = take()) {
        socket.getOutputStream().write(next);
      }
    } catch (IOException e) {
      end(String.valueOf(e.getMessage()));
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
    } finally {
      flushed.countDown();
    }
  }

  private synchronized byte[] take() throws InterruptedException {
    while (newest.isEmpty() && waiting.isEmpty() && !finishing) {
      wait();
    }
    if (!newest.isEmpty()) {
      return newest.remove(newest.keySet().iterator().next());
    }
    byte[] next = waiting.isEmpty() ? new byte[0] : waiting.remove();
    waitingBytes -= next.length;
    return next;
  }

  /**
   * Sends a frame in its turn.
   *
   * @param frame to be sent
   * @return false where the link has ended, or too much waits
   */
  public boolean send(F frame) {
    return send(framing.bytes(frame));
  }

  /**
   * Sends bytes in their turn.
   *
   * @param bytes to be sent
   * @return false where the link has ended, or too much waits
   */
  public synchronized boolean send(byte[] bytes) {
    if (finishing || waiting.size() >= MOST_FRAMES || waitingBytes + bytes.length > MOST_BYTES) {
      return false;
    }
    waiting.add(bytes);
    waitingBytes += bytes.length;
    notifyAll();
    return true;
  }

  /**
   * Sends a frame in place of an older one of its kind that still waits.
   *
   * @param kind which of those that wait it replaces
   * @param frame to be sent
   * @return false where the link has ended
   */
  public synchronized boolean replace(String kind, F frame) {
    if (finishing) {
      return false;
    }
    newest.put(kind, framing.bytes(frame));
    notifyAll();
    return true;
  }

  private void end(String reason) {
    synchronized (this) {
      finish();
      if (ended) {
        return;
      }
      ended = true;
    }
    Sockets.closeQuietly(socket);
    receiver.ended(this, reason);
  }

  /** Takes nothing more to be sent, and goes on to send what waits; does not block. */
  public synchronized void finish() {
    if (!finishing) {
      finishing = true;
      finishingSince = System.nanoTime();
    }
    notifyAll();
  }

  private synchronized long finishingSince() {
    return finishingSince;
  }

  /**
   * Whether nothing is taken any more.
   *
   * @return true from the beginning of its end
   */
  public synchronized boolean isOver() {
    return finishing;
  }

  /** Sends what waits, where the peer takes it within a moment since {@link #finish}, and ends. */
  @Override
  public void close() {
    finish();
    try {
      flushed.await(finishingSince() + FLUSH_NANOS - System.nanoTime(), TimeUnit.NANOSECONDS);
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
    }
    end("it was closed");
  }
}
