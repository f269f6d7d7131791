package org.robotui.guard.internal.client;

import java.io.BufferedReader;
import java.io.ByteArrayOutputStream;
import java.io.DataOutputStream;
import java.io.IOException;
import java.io.InputStreamReader;
import java.io.OutputStream;
import java.net.InetSocketAddress;
import java.nio.charset.StandardCharsets;
import java.time.Duration;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.ExecutionException;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.TimeoutException;
import java.util.concurrent.atomic.AtomicInteger;
import org.robotui.guard.internal.wire.Wire;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/** One process of a guard, and the two threads that speak and listen to it. */
final class GuardProcess {
  private static final Logger LOG = LoggerFactory.getLogger(GuardProcess.class);
  private static final Duration START = Duration.ofSeconds(15);
  private static final Duration END = Duration.ofMillis(1500);
  /** So many beats without an echo: it hangs. */
  private static final int MOST_UNHEARD = 50;

  /** Hears of what happens; called on a thread of the process. */
  interface Listener {
    void overflow();

    void silence();

    /** It is gone, and nobody asked it to. */
    void lost();
  }

  private final Process process;
  private final Secrets secrets;
  private final Listener listener;
  private final OutputStream orders;
  private final CompletableFuture<Integer> port = new CompletableFuture<>();
  private final AtomicInteger unheard = new AtomicInteger();
  private volatile boolean closed;

  private GuardProcess(Process process, Secrets secrets, Listener listener) {
    this.process = process;
    this.secrets = secrets;
    this.listener = listener;
    this.orders = process.getOutputStream();
  }

  /** Starts one and waits for its port. */
  static GuardProcess start(Launch launch, Listener listener) throws IOException {
    GuardProcess made = new GuardProcess(launch.start(), Secrets.fresh(), listener);
    try {
      made.greet();
      return made;
    } catch (IOException | RuntimeException e) {
      made.close();
      throw e;
    }
  }

  private void greet() throws IOException {
    send(out -> {
      out.write(secrets.knock());
      out.write(secrets.answer());
    });
    thread("guard listens", this::listen);
    try {
      port.get(START.toMillis(), TimeUnit.MILLISECONDS);
    } catch (ExecutionException | TimeoutException e) {
      throw new IOException("the guard did not start: " + e.getMessage(), e);
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
      throw new IOException("the guard was not waited for", e);
    }
    thread("guard beats", this::beat);
  }

  private static void thread(String name, Runnable work) {
    Thread thread = new Thread(work, name);
    thread.setDaemon(true);
    thread.start();
  }

  long pid() {
    return process.pid();
  }

  boolean isAlive() {
    return process.isAlive() && !closed;
  }

  Secrets secrets() {
    return secrets;
  }

  int port() {
    return port.getNow(0);
  }

  /** What an order is made of. */
  @FunctionalInterface
  private interface Order {
    void write(DataOutputStream out) throws IOException;
  }

  private void send(Order order) throws IOException {
    ByteArrayOutputStream frame = new ByteArrayOutputStream();
    order.write(new DataOutputStream(frame));
    synchronized (orders) {
      frame.writeTo(orders);
      orders.flush();
    }
  }

  void keep(int id, InetSocketAddress to, byte[] words) throws IOException {
    send(out -> {
      out.writeByte(Wire.KEEP);
      out.writeInt(id);
      out.writeByte(to.getAddress().getAddress().length);
      out.write(to.getAddress().getAddress());
      out.writeShort(to.getPort());
      out.writeInt(words.length);
      out.write(words);
    });
  }

  void withdraw(int id) throws IOException {
    send(out -> {
      out.writeByte(Wire.WITHDRAW);
      out.writeInt(id);
    });
  }

  private void beat() {
    try {
      while (isAlive()) {
        send(out -> out.writeByte(Wire.BEAT));
        if (unheard.incrementAndGet() > MOST_UNHEARD) {
          LOG.warn("the guard {} hangs and is ended", pid());
          process.destroyForcibly();
        }
        Thread.sleep(Wire.BEATS);
      }
    } catch (IOException e) {
      LOG.debug("the guard {} hears nothing any more: {}", pid(), e.getMessage());
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
    }
  }

  private void listen() {
    String last = "";
    try (BufferedReader in =
        new BufferedReader(new InputStreamReader(process.getInputStream(), StandardCharsets.UTF_8))) {
      for (String line = in.readLine(); line != null; line = in.readLine()) {
        last = line;
        heard(line);
      }
    } catch (IOException e) {
      LOG.debug("the guard {} says nothing any more: {}", pid(), e.getMessage());
    }
    port.completeExceptionally(new IOException("it ended: " + last));
    if (!closed) {
      listener.lost();
    }
  }

  private void heard(String line) {
    if (line.equals(Wire.ECHO)) {
      unheard.set(0);
    } else if (line.startsWith(Wire.PORT)) {
      port.complete(Integer.parseInt(line.substring(Wire.PORT.length())));
    } else if (line.startsWith(Wire.OVERFLOW)) {
      listener.overflow();
      LOG.warn("a connection was closed since what came was not taken in time: {} (bytes waiting)",
          line.substring(Wire.OVERFLOW.length()));
    } else if (line.startsWith(Wire.SILENCE)) {
      listener.silence();
      LOG.warn("this process was silent for too long: {}", line.substring(Wire.SILENCE.length()));
    } else {
      LOG.warn("the guard {} says: {}", pid(), line);
    }
  }

  /** Says goodbye; a guard that does not end is ended. */
  void close() {
    closed = true;
    try {
      send(out -> out.writeByte(Wire.GOODBYE));
      orders.close();
      if (!process.waitFor(END.toMillis(), TimeUnit.MILLISECONDS)) {
        process.destroyForcibly();
      }
    } catch (IOException e) {
      process.destroyForcibly();
    } catch (InterruptedException e) {
      process.destroyForcibly();
      Thread.currentThread().interrupt();
    }
  }
}
