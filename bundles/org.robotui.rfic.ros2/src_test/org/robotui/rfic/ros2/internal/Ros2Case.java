package org.robotui.rfic.ros2.internal;

import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.time.Duration;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.concurrent.ThreadFactory;
import java.util.concurrent.locks.LockSupport;
import java.util.function.BooleanSupplier;
import java.util.function.Consumer;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.robotui.api.Rfic;
import org.robotui.api.config.Settings;
import org.robotui.api.port.CallException;
import org.robotui.api.port.CallHandler;
import org.robotui.api.port.CommandSink;
import org.robotui.api.port.CommandSink.Sent;
import org.robotui.data.Data;
import org.robotui.data.record.DynamicRecord;
import org.robotui.rfic.ros2.internal.graph.SharedDomains;
import org.robotui.ros2.Ros2Context;
import org.robotui.ros2.Ros2Environment;
import org.robotui.ros2.Ros2Node;
import org.robotui.ros2.Ros2Options;
import org.robotui.testkit.FakeRficContext;

/** A node of a robot, and an interface to it. */
abstract class Ros2Case {
  static final ThreadFactory DAEMONS = Thread.ofPlatform().daemon().factory();
  private static final Duration CALL = Duration.ofSeconds(3);
  static final Duration PATIENCE = Duration.ofSeconds(60);

  final FakeRficContext context = new FakeRficContext();
  final SharedDomains domains = new SharedDomains();
  private final List<AutoCloseable> opened = new ArrayList<>();
  Ros2Node robot;
  Rfic rfic;

  @BeforeEach
  void openRobot() throws IOException {
    robot = node("robot");
    rfic = rfic(context, Map.of());
  }

  @AfterEach
  void closeAll() throws Exception {
    for (AutoCloseable each : opened.reversed()) {
      each.close();
    }
  }

  Ros2Node node(String name) throws IOException {
    Ros2Context ros = Ros2Context.open(Ros2Environment.local(Ros2Peer.DOMAIN), Ros2Options.standard(DAEMONS));
    opened.add(ros);
    return ros.node(name);
  }

  Rfic rfic(FakeRficContext its, Map<String, Object> written) {
    Map<String, Object> all = new HashMap<>(Map.of("domain", (long) Ros2Peer.DOMAIN));
    all.putAll(written);
    Rfic made = Ros2Sessions.rfic(its, settings(all), domains);
    opened.add(made::close);
    return made;
  }

  static Ros2Settings settings(Map<String, Object> written) {
    Map<String, Object> values = new HashMap<>();
    Ros2Settings.SCHEMA.settings().forEach(s -> s.fallback().ifPresent(f -> values.put(s.name(), f)));
    values.putAll(written);
    written.keySet().forEach(k -> assertTrue(Ros2Settings.SCHEMA.find(k).isPresent(), k));
    return Ros2Settings.of(new Settings(Ros2Settings.SCHEMA, values), Map.of());
  }

  FakeRficContext.Published first(String port) {
    await(() -> context.published.containsKey(port) && !context.published.get(port).isEmpty());
    return context.published.get(port).getFirst();
  }

  @SuppressWarnings("unchecked")
  Sent send(String port, Data command) {
    return ((CommandSink<Data>) context.sinks.get(port)).send(command);
  }

  <Q, R> R call(String port, Q request) throws CallException, InterruptedException {
    return call(port, request, feedback -> {});
  }

  @SuppressWarnings("unchecked")
  <Q, R> R call(String port, Q request, Consumer<DynamicRecord> told) throws CallException, InterruptedException {
    await(() -> context.handlers.containsKey(port));
    return ((CallHandler<Q, R>) context.handlers.get(port)).handle(new Asked<>(request, told,
        System.nanoTime() + CALL.toNanos()));
  }

  /** A call that may take three seconds. */
  private record Asked<Q>(Q request, Consumer<DynamicRecord> told, long deadlineNanos)
      implements CallHandler.Invocation<Q> {
    @Override
    public void progress(double fraction, String message) {
      // what matters is how it ends
    }

    @Override
    public void feedback(DynamicRecord record) {
      told.accept(record);
    }
  }

  static void await(BooleanSupplier condition) {
    long end = System.nanoTime() + PATIENCE.toNanos();
    while (!condition.getAsBoolean()) {
      assertTrue(System.nanoTime() < end, "waited in vain");
      LockSupport.parkNanos(5_000_000);
    }
  }
}
