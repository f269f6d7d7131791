package org.robotui.bridge.internal.carry;

import java.nio.file.Path;
import java.time.Duration;
import java.util.List;
import java.util.Map;
import java.util.concurrent.locks.LockSupport;
import java.util.function.BooleanSupplier;
import java.util.function.Supplier;
import org.robotui.api.bridge.BridgeConfig;
import org.robotui.api.bridge.BridgeEnd;
import org.robotui.api.bridge.BridgeStatus;
import org.robotui.api.bridge.BridgeWords;
import org.robotui.api.port.Arity;
import org.robotui.api.port.CommandPort;
import org.robotui.api.port.SourceId;
import org.robotui.api.port.StreamPort;
import org.robotui.bridge.internal.TransformTable;
import org.robotui.data.Data;
import org.robotui.data.command.RelayMessage;
import org.robotui.data.command.VelocityCommand;
import org.robotui.data.navigation.NavigationGoal;
import org.robotui.testkit.FakeSettings;
import org.robotui.testkit.host.FakeHost;
import org.robotui.testkit.host.FakePortAccess;
import org.robotui.testkit.host.FakeRuic;

/** Two robots with the same ports, and a bridge between them. */
final class TwoRobots implements AutoCloseable {
  private static final Duration PATIENCE = Duration.ofSeconds(20);

  final FakeHost host = new FakeHost();
  final FakeRuic natalie = new FakeRuic("Natalie");
  final FakeRuic keira = new FakeRuic("Keira");
  private final TransformTable transforms = new TransformTable();
  private BridgeRunner runner;

  TwoRobots() {
    for (FakeRuic robot : List.of(natalie, keira)) {
      robot.ports().offer("base", new StreamPort<>("said", Data.class, Arity.MANY, ""));
      offerCommands(robot);
      host.add(robot);
    }
  }

  static void offerCommands(FakeRuic robot) {
    robot.ports().offer("base", new CommandPort<>("relay", RelayMessage.class, Arity.MANY, ""),
        new CommandPort<>("cmd_vel", VelocityCommand.class, Arity.MANY, ""),
        new CommandPort<>("goal", NavigationGoal.class, Arity.MANY, ""));
  }

  TransformTable transforms() {
    return transforms;
  }

  /** A bridge from what Natalie says to a port or topic of Keira, with settings that are fit for it. */
  TwoRobots bridge(String to, Map<String, Object> settings) {
    return bridge("said", to, settings);
  }

  /** The same from any port. */
  TwoRobots bridge(String from, String to, Map<String, Object> settings) {
    FakeSettings values = new FakeSettings(BridgeWords.SCHEMA);
    settings.forEach(values::set);
    host.bridging(new BridgeConfig(Path.of("test.yaml"), 3, "test", end("Natalie", from), end("Keira", to),
        values.current()));
    runner = new BridgeRunner(host, transforms);
    await(() -> !runner.statuses().isEmpty());
    return this;
  }

  static BridgeEnd end(String ruic, String port) {
    return new BridgeEnd(ruic, new SourceId("base", port));
  }

  void says(Data value) {
    natalie.ports().put(new SourceId("base", "said"), value);
  }

  FakePortAccess at(FakeRuic robot) {
    return robot.ports();
  }

  /** What Keira was told, of one type. */
  <T extends Data> List<T> heard(Class<T> type) {
    return keira.ports().commands().stream().filter(type::isInstance).map(type::cast).toList();
  }

  BridgeStatus status() {
    return runner.statuses().getFirst();
  }

  List<BridgeStatus> statuses() {
    return runner.statuses();
  }

  void awaitText(String part) {
    await(() -> status().text().contains(part), () -> "it says: " + status());
  }

  /** Said again and again, without a pause. */
  void saysUntilText(Data value, String part) {
    await(() -> {
      says(value);
      LockSupport.parkNanos(5_000_000);
      return status().text().contains(part);
    }, () -> "it says: " + status());
  }

  static void await(BooleanSupplier condition) {
    await(condition, () -> "");
  }

  static void await(BooleanSupplier condition, Supplier<String> seen) {
    long end = System.nanoTime() + PATIENCE.toNanos();
    while (!condition.getAsBoolean()) {
      if (System.nanoTime() > end) {
        throw new AssertionError("it did not come to that within " + PATIENCE + "; " + seen.get());
      }
      Thread.onSpinWait();
    }
  }

  @Override
  public void close() {
    runner.close();
  }
}
