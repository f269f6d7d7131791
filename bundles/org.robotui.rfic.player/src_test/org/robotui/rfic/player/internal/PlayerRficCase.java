package org.robotui.rfic.player.internal;

import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.time.Duration;
import java.util.HashMap;
import java.util.Map;
import java.util.Set;
import java.util.concurrent.ConcurrentHashMap;
import java.util.concurrent.ThreadFactory;
import java.util.concurrent.locks.LockSupport;
import java.util.function.BooleanSupplier;
import java.util.function.IntConsumer;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.robotui.api.Rfic;
import org.robotui.api.config.Setting;
import org.robotui.api.config.Settings;
import org.robotui.api.link.LinkState;
import org.robotui.api.port.CallException;
import org.robotui.api.port.CallHandler;
import org.robotui.api.port.CommandSink;
import org.robotui.api.port.CommandSink.Sent;
import org.robotui.api.port.ServiceReply;
import org.robotui.api.port.ServiceRequest;
import org.robotui.data.Data;
import org.robotui.data.record.DynamicRecord;
import org.robotui.guard.Guards;
import org.robotui.player.layout.Layouts;
import org.robotui.player.server.PlayerServer;
import org.robotui.player.server.ServedDevice;
import org.robotui.player.server.ServerOptions;
import org.robotui.player.server.TypedHandler;
import org.robotui.testkit.FakeRficContext;

/** A Player server of its own, and an interface to it. */
abstract class PlayerRficCase {
  static final ThreadFactory DAEMONS = Thread.ofPlatform().daemon().factory();
  static final Duration PATIENCE = Duration.ofSeconds(60);
  /** Of a robot's clock. */
  static final double STAMP = 1.7e9;

  final Layouts layouts = Layouts.standard();
  final FakeRficContext context = new FakeRficContext();
  final Map<String, Integer> clients = new ConcurrentHashMap<>();
  final Set<String> everOpened = ConcurrentHashMap.newKeySet();
  PlayerServer server;
  Rfic rfic;

  @BeforeEach
  void openServer() throws IOException {
    server = serve(0);
  }

  @AfterEach
  void closeAll() {
    if (rfic != null) {
      rfic.close();
      await("no thread is left", () -> context.alive().isEmpty());
    }
    server.close();
  }

  PlayerServer serve(int port) throws IOException {
    return new PlayerServer(layouts, ServerOptions.loopback(DAEMONS, port, () -> STAMP));
  }

  TypedHandler handler(String device) {
    IntConsumer counted = count -> {
      clients.put(device, count);
      if (count > 0) {
        everOpened.add(device);
      }
    };
    return new TypedHandler(layouts, counted);
  }

  ServedDevice add(String device, TypedHandler handler) {
    int colon = device.indexOf(':');
    return server.add(device.substring(0, colon), Integer.parseInt(device.substring(colon + 1)),
        "driver_of_" + device.substring(0, colon),
        handler);
  }

  void start(Map<String, Object> written) {
    Map<String, Object> all = new HashMap<>(Map.of("host", "127.0.0.1", "port", (long) server.port()));
    all.putAll(written);
    rfic = PlayerSessions.rfic(context, settings(all, Map.of()), new Guards());
    rfic.start();
  }

  void startConnected() {
    start(Map.of());
    await("the link is made", () -> link() instanceof LinkState.Connected);
  }

  LinkState link() {
    return context.links.isEmpty() ? new LinkState.Disconnected() : context.links.getLast();
  }

  static PlayerSettings settings(Map<String, Object> written, Map<String, String> variables) {
    Map<String, Object> values = new HashMap<>();
    PlayerSettings.SCHEMA.settings().forEach(s -> s.fallback().ifPresent(f -> values.put(s.name(), f)));
    values.putAll(written);
    written.keySet().forEach(k -> assertTrue(PlayerSettings.SCHEMA.find(k).map(Setting::name).isPresent(), k));
    return PlayerSettings.of(new Settings(PlayerSettings.SCHEMA, values), variables);
  }

  /** Wants a stream and waits until its device is open. */
  void want(String port) {
    await(port + " is offered", () -> context.streams.containsKey(port));
    context.demand(port, true);
    String device = port.contains("/") ? port.substring(0, port.indexOf('/')) : port;
    await(device + " is open", () -> clients.getOrDefault(device, 0) > 0);
  }

  FakeRficContext.Published first(String port) {
    await("something comes by " + port,
        () -> context.published.containsKey(port) && !context.published.get(port).isEmpty());
    return context.published.get(port).getFirst();
  }

  @SuppressWarnings("unchecked")
  Sent send(String port, Data command) {
    return ((CommandSink<Data>) context.sinks.get(port)).send(command);
  }

  /** As core does while a stop is latched. */
  @SuppressWarnings("unchecked")
  Sent stop(String port, Data zero, boolean ours) {
    return ((CommandSink<Data>) context.sinks.get(port)).stop(zero, ours);
  }

  @SuppressWarnings("unchecked")
  DynamicRecord call(String service, Map<String, Object> arguments) throws CallException {
    CallHandler<ServiceRequest, ServiceReply> handler =
        (CallHandler<ServiceRequest, ServiceReply>) context.handlers.get("services");
    try {
      return handler.handle(new Asked(new ServiceRequest(service, arguments))).value();
    } catch (InterruptedException e) {
      throw new AssertionError(e);
    }
  }

  private record Asked(ServiceRequest request) implements CallHandler.Invocation<ServiceRequest> {
    @Override
    public long deadlineNanos() {
      return System.nanoTime() + Duration.ofSeconds(20).toNanos();
    }

    @Override
    public void progress(double fraction, String message) {
      // nobody looks
    }

    @Override
    public void feedback(DynamicRecord record) {
      // nobody looks
    }
  }

  static void await(String what, BooleanSupplier condition) {
    long end = System.nanoTime() + PATIENCE.toNanos();
    while (!condition.getAsBoolean()) {
      assertTrue(System.nanoTime() < end, "waited in vain: " + what);
      LockSupport.parkNanos(5_000_000);
    }
  }
}
