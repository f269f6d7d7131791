package org.robotui.rfic.ros.internal;

import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.net.URI;
import java.time.Duration;
import java.util.HashMap;
import java.util.Map;
import java.util.concurrent.ThreadFactory;
import java.util.concurrent.locks.LockSupport;
import java.util.function.BooleanSupplier;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.robotui.api.config.Setting;
import org.robotui.api.config.Settings;
import org.robotui.api.port.CallException;
import org.robotui.api.port.CallHandler;
import org.robotui.api.port.CommandSink;
import org.robotui.api.port.CommandSink.Sent;
import org.robotui.data.ClockKind;
import org.robotui.data.Data;
import org.robotui.data.Stamp;
import org.robotui.data.record.DynamicRecord;
import org.robotui.data.record.FieldPath;
import org.robotui.data.record.FieldValue;
import org.robotui.guard.Guards;
import org.robotui.message.ros.std_msgs.Header;
import org.robotui.rfic.ros.internal.graph.SharedMasters;
import org.robotui.ros.GraphName;
import org.robotui.ros.NodeOptions;
import org.robotui.ros.RosEnvironment;
import org.robotui.ros.RosNode;
import org.robotui.ros.master.MasterOptions;
import org.robotui.ros.master.RosMaster;
import org.robotui.testkit.FakeRficContext;

/** A robot on a master of its own, and an interface to it. */
abstract class RosRficCase {
  static final ThreadFactory DAEMONS = Thread.ofPlatform().daemon().factory();
  static final Duration PATIENCE = Duration.ofSeconds(60);

  final FakeRficContext context = new FakeRficContext();
  RosMaster master;
  RosNode robot;
  RosRfic rfic;

  @BeforeEach
  void openRobot() throws IOException {
    master = RosMaster.open(MasterOptions.standard(DAEMONS));
    robot = node("robot");
    rfic = new RosRfic(context, settings(Map.of("master", master.uri().toString())), new SharedMasters(), new Guards());
  }

  @AfterEach
  void closeAll() {
    rfic.close();
    robot.close();
    master.close();
  }

  RosNode node(String name) throws IOException {
    return RosNode.open(RosEnvironment.of(URI.create(master.uri().toString())), GraphName.of(name),
        NodeOptions.standard(DAEMONS));
  }

  static RosSettings settings(Map<String, Object> written) {
    Map<String, Object> values = new HashMap<>();
    RosSettings.SCHEMA.settings().forEach(s -> s.fallback().ifPresent(f -> values.put(s.name(), f)));
    values.putAll(written);
    written.keySet().forEach(k -> assertTrue(RosSettings.SCHEMA.find(k).map(Setting::name).isPresent()));
    return RosSettings.of(new Settings(RosSettings.SCHEMA, values), Map.of());
  }

  static org.robotui.message.ros.sensor_msgs.LaserScan scan(float[] ranges) {
    Header header = new Header(0, Stamp.of(12, 500, ClockKind.ROBOT).nanos(), "/laser");
    return new org.robotui.message.ros.sensor_msgs.LaserScan(header, -1, 1, 0.5f, 0, 0, 0.1f, 30, ranges, new float[0]);
  }

  FakeRficContext.Published first(String port) {
    await(() -> context.published.containsKey(port) && !context.published.get(port).isEmpty());
    return context.published.get(port).getFirst();
  }

  static double number(FakeRficContext.Published published) {
    FieldValue value = ((DynamicRecord) published.value()).at(FieldPath.parse("data")).orElseThrow();
    return ((FieldValue.Num) value).value();
  }

  @SuppressWarnings("unchecked")
  Sent send(String port, Data command) {
    return ((CommandSink<Data>) context.sinks.get(port)).send(command);
  }

  @SuppressWarnings("unchecked")
  <Q, R> R call(String port, Q request) throws CallException, InterruptedException {
    await(() -> context.handlers.containsKey(port));
    return ((CallHandler<Q, R>) context.handlers.get(port)).handle(new CallHandler.Invocation<>() {
      @Override
      public Q request() {
        return request;
      }

      @Override
      public long deadlineNanos() {
        return System.nanoTime() + Duration.ofSeconds(30).toNanos();
      }

      @Override
      public void progress(double fraction, String message) {
        // services have no progress
      }

      @Override
      public void feedback(DynamicRecord record) {
        // nor feedback
      }
    });
  }

  static void await(BooleanSupplier condition) {
    long end = System.nanoTime() + PATIENCE.toNanos();
    while (!condition.getAsBoolean()) {
      assertTrue(System.nanoTime() < end, "waited in vain");
      LockSupport.parkNanos(5_000_000);
    }
  }

}
