package org.robotui.player;

import java.io.IOException;
import java.time.Duration;
import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.CopyOnWriteArrayList;
import java.util.concurrent.ExecutionException;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.TimeoutException;
import java.util.function.UnaryOperator;
import org.robotui.net.call.Outcome;
import org.robotui.player.client.ClientOptions;
import org.robotui.player.client.LinkState;
import org.robotui.player.client.PlayerClient;
import org.robotui.player.layout.Layouts;
import org.robotui.player.server.PlayerServer;
import org.robotui.player.server.ServerOptions;

/** A server and clients of one test. Times are long, as machines are busy; nothing waits for them when all is well. */
final class World implements AutoCloseable {

  static final Duration LONG = Duration.ofSeconds(60);
  static final double STAMP = 12.25;

  final TestThreads threads = new TestThreads();
  final Layouts layouts = Layouts.standard();
  final List<LinkState> links = new CopyOnWriteArrayList<>();
  private final List<AutoCloseable> open = new ArrayList<>();

  PlayerServer server(int port) throws IOException {
    return server(ServerOptions.loopback(threads, port, () -> STAMP));
  }

  PlayerServer server(ServerOptions options) throws IOException {
    return closing(new PlayerServer(layouts, options));
  }

  PlayerClient client(int port) {
    return client(port, options -> options);
  }

  PlayerClient client(int port, UnaryOperator<ClientOptions> change) {
    ClientOptions patient =
        ClientOptions.standard(threads).withTimes(LONG, LONG, LONG, Duration.ofMillis(200)).withLinks(links::add);
    return closing(new PlayerClient("127.0.0.1", port, layouts, change.apply(patient)));
  }

  PlayerClient connected(int port) {
    PlayerClient client = client(port);
    awaitLink(client);
    return client;
  }

  static void awaitLink(PlayerClient client) {
    Eventually.await("the link is made", () -> client.state() instanceof LinkState.Connected);
  }

  <T extends AutoCloseable> T closing(T resource) {
    open.add(resource);
    return resource;
  }

  static <T> Outcome<T> outcome(CompletableFuture<Outcome<T>> future) {
    try {
      return future.get(LONG.toSeconds(), TimeUnit.SECONDS);
    } catch (InterruptedException | ExecutionException | TimeoutException e) {
      throw new AssertionError("no outcome", e);
    }
  }

  static <T> T value(CompletableFuture<Outcome<T>> future) {
    Outcome<T> outcome = outcome(future);
    return outcome.toOptional().orElseThrow(() -> new AssertionError(outcome.toString()));
  }

  @Override
  public void close() throws Exception {
    for (AutoCloseable each : open.reversed()) {
      each.close();
    }
    threads.assertNoneLeft();
  }
}
