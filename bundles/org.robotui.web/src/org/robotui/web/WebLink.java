package org.robotui.web;

import java.io.IOException;
import java.net.URI;
import java.net.http.HttpClient;
import java.net.http.WebSocket;
import java.time.Duration;
import java.util.Optional;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.ExecutionException;
import java.util.concurrent.ExecutorService;
import java.util.concurrent.Executors;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.TimeoutException;

/**
 * A link to a server by WebSocket. Messages are bounded in both directions; what is received is taken from the network
 * at once, so that nothing grows old there. A command goes out before all that waits, or not at all. Safe for all
 * threads.
 */
public final class WebLink implements LinkMonitor, AutoCloseable {

  private static final Duration FAREWELL = Duration.ofMillis(300);
  private static final Duration LATE = Duration.ofSeconds(1);
  private static final long SECOND = 1_000_000_000L;
  private static final Duration END = Duration.ofMillis(700);

  private final URI address;
  private final HttpClient client;
  private final ExecutorService workers;
  private final WebSocket socket;
  private final WebOutbox outbox;
  private final LinkHeartbeat heartbeat;
  private final CompletableFuture<String> ended;

  private WebLink(URI address, HttpClient client, ExecutorService workers, WebSocket socket, WebReceiver ear) {
    this.address = address;
    this.client = client;
    this.workers = workers;
    this.socket = socket;
    this.ended = ear.ended();
    this.heartbeat = ear.heartbeat();
    this.outbox = new WebOutbox(socket, ear::failed);
  }

  /**
   * Connects, which blocks.
   *
   * @param address such as {@code ws://robot:8765}; {@code wss} for TLS
   * @param options how
   * @param listener hears what comes, from the first message on
   * @return the link
   * @throws IOException if nobody answers as a WebSocket there; says who and why
   * @throws InterruptedException if the thread was interrupted
   */
  public static WebLink open(URI address, WebOptions options, WebListener listener)
      throws IOException, InterruptedException {
    ExecutorService workers = Executors.newCachedThreadPool(options.threads());
    HttpClient client = HttpClient.newBuilder().executor(workers).proxy(HttpClient.Builder.NO_PROXY)
        .connectTimeout(options.connecting()).build();
    boolean open = false;
    try {
      WebReceiver ear = new WebReceiver(listener, options.longest());
      WebSocket socket = await(builder(client, options).buildAsync(address, ear), options.connecting());
      open = true;
      return new WebLink(address, client, workers, socket, ear);
    } catch (ExecutionException e) {
      throw new IOException(WebFaults.said(address, e.getCause()), e.getCause());
    } catch (TimeoutException e) {
      throw new IOException(address + " has not answered within " + options.connecting().toMillis() + " ms", e);
    } catch (IllegalArgumentException e) {
      throw new IOException(address + " is no address of a WebSocket: " + e.getMessage(), e);
    } finally {
      if (!open) {
        end(client, workers);
      }
    }
  }

  private static WebSocket.Builder builder(HttpClient client, WebOptions options) {
    WebSocket.Builder builder = client.newWebSocketBuilder().connectTimeout(options.connecting());
    if (!options.subprotocols().isEmpty()) {
      builder.subprotocols(options.subprotocols().getFirst(),
          options.subprotocols().stream().skip(1).toArray(String[]::new));
    }
    return builder;
  }

  private static WebSocket await(CompletableFuture<WebSocket> opening, Duration patience)
      throws ExecutionException, TimeoutException, InterruptedException {
    try {
      return opening.get(patience.toNanos(), TimeUnit.NANOSECONDS);
    } catch (TimeoutException | InterruptedException e) {
      opening.whenComplete((late, error) -> Optional.ofNullable(late).ifPresent(WebSocket::abort));
      throw e;
    }
  }

  /**
   * The subprotocol that the server has chosen.
   *
   * @return one of those that were offered, or empty
   */
  public String subprotocol() {
    return socket.getSubprotocol();
  }

  @Override
  public CompletableFuture<String> whenEnded() {
    return ended.thenApply(reason -> address + " " + reason);
  }

  /**
   * Says something after all that waits.
   *
   * @param payload the message
   * @return false where too much waits, it is too long (4 MiB), or the link has ended
   */
  public boolean say(WebPayload payload) {
    return !ended.isDone() && outbox.add(payload);
  }

  /**
   * Sends before all that waits. What is not on its way when the time is over is taken back.
   *
   * @param payload the message
   * @param patience how long to wait for the network to take it
   * @return whether it is on its way
   * @throws InterruptedException if the thread was interrupted; then it is taken back as well
   */
  public boolean command(WebPayload payload, Duration patience) throws InterruptedException {
    return !ended.isDone() && outbox.command(payload, patience);
  }

  @Override
  public void beat() {
    if (!ended.isDone()) {
      heartbeat.beat(System.nanoTime());
    }
  }

  @Override
  public long silentNanos() {
    return heartbeat.silentNanos(System.nanoTime());
  }

  /**
   * How long an answer takes, which is how old what comes is when it comes.
   *
   * @return nanoseconds, 0 before the first answer
   */
  public long roundTripNanos() {
    return heartbeat.roundTripNanos(System.nanoTime());
  }

  @Override
  public String trouble() {
    long silent = silentNanos();
    if (silent > LATE.toNanos()) {
      return "nothing has come for " + silent / SECOND + " s, although an answer is awaited";
    }
    long late = roundTripNanos();
    return late > LATE.toNanos()
        ? "answers take " + late / SECOND + " s: more is asked for than the network carries"
        : "";
  }

  /** Says what waits, for a moment, takes leave, and ends the link with all its threads. */
  @Override
  public void close() {
    try {
      if (!ended.isDone() && silentNanos() < END.toNanos()) {
        outbox.drain(FAREWELL);
        socket.sendClose(WebSocket.NORMAL_CLOSURE, "").get(FAREWELL.toMillis(), TimeUnit.MILLISECONDS);
      }
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
    } catch (ExecutionException | TimeoutException e) {
      // it does not take our leave; it is over in any case
    } finally {
      ended.complete("was closed from here");
      outbox.close();
      socket.abort();
      end(client, workers);
    }
  }

  private static void end(HttpClient client, ExecutorService workers) {
    client.shutdownNow();
    workers.shutdownNow();
    try {
      client.awaitTermination(END);
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
    }
  }
}
