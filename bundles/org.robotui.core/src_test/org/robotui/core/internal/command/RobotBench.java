package org.robotui.core.internal.command;

import java.time.Duration;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.concurrent.CopyOnWriteArrayList;
import java.util.concurrent.atomic.AtomicInteger;
import org.robotui.api.link.LinkState;
import org.robotui.api.port.Arity;
import org.robotui.api.port.CommandPort;
import org.robotui.api.port.CommandSink;
import org.robotui.api.port.Demand;
import org.robotui.api.port.SourceId;
import org.robotui.api.port.StreamPort;
import org.robotui.core.internal.config.model.SafetyConfig;
import org.robotui.core.internal.port.Link;
import org.robotui.core.internal.port.StreamSource;
import org.robotui.core.internal.support.Await;
import org.robotui.core.internal.support.ManualClock;
import org.robotui.core.internal.support.Samples;
import org.robotui.core.internal.time.Ageing;
import org.robotui.data.Data;
import org.robotui.data.FrameId;
import org.robotui.data.array.Doubles;
import org.robotui.data.command.VelocityCommand;
import org.robotui.data.navigation.NavigationGoal;
import org.robotui.data.navigation.Odometry;
import org.robotui.geometry.RigidTransform;
import org.robotui.geometry.Vector3;

/** A robot with a velocity and a goal port, an arbiter whose time the test moves, and a sender whose thread is real. */
final class RobotBench implements RobotPorts, AutoCloseable {
  final ManualClock clock = new ManualClock();
  final Link link = new Link(clock, () -> {});
  final DisplayWatch display = new DisplayWatch(clock);
  final AtomicInteger wakes = new AtomicInteger();
  final Arbiter arbiter = new Arbiter("pioneer", clock, display, wakes::incrementAndGet);
  final Sender sender = new Sender("base", Thread.ofPlatform().daemon().factory(), clock);
  final List<Data> sent = new CopyOnWriteArrayList<>();
  final List<String> alerts = new CopyOnWriteArrayList<>();
  final AtomicInteger cancels = new AtomicInteger();
  final AtomicInteger stopCalls = new AtomicInteger();
  final CommandTarget<VelocityCommand> velocity = target(Samples.VELOCITY, this::out);
  final CommandTarget<NavigationGoal> goal = target(Samples.GOAL, this::out);
  final StreamSource<Odometry> odometry = new StreamSource<>(new SourceId("base", "odom"),
      new StreamPort<>("odom", Odometry.class, Arity.MANY, ""), link, clock, Ageing.by(clock), Demand.IGNORED,
      Runnable::run, o -> {});
  final List<CommandTarget<?>> targets = new ArrayList<>(List.of(velocity, goal));
  SafetyConfig safety = SafetyConfig.DEFAULT;

  RobotBench() {
    link.report(new LinkState.Connected("robot"));
    arbiter.register(this);
  }

  <T extends Data> CommandTarget<T> target(CommandPort<T> port, CommandSink<T> sink) {
    return new CommandTarget<>(new SourceId("base", port.name()), port, sink, link, arbiter, sender, clock, o -> {});
  }

  private CommandSink.Sent out(Data command) {
    sent.add(command);
    return new CommandSink.Sent.Out();
  }

  /** Lets time pass in steps of ten milliseconds, as the arbiter's thread would see it. */
  void pass(long millis) {
    for (long t = 0; t < millis; t += 10) {
      clock.advanceMillis(10);
      arbiter.step();
      settle();
    }
  }

  /** Waits until the sender has nothing to do. */
  void settle() {
    try {
      sender.flush(Duration.ofSeconds(5));
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
    }
  }

  void awaitSent(int count) {
    Await.until(count + " are sent", () -> sent.size() >= count);
  }

  long zeros() {
    return sent.stream().filter(VelocityCommand.ZERO::equals).count();
  }

  @Override
  public List<CommandTarget<?>> commands() {
    return targets;
  }

  @Override
  public List<StreamSource<?>> streams() {
    return List.of(odometry);
  }

  /** The robot says that it moves, or that it stands. */
  void report(double metresPerSecond) {
    odometry.publish(
        new Odometry(new FrameId("pioneer", "odom"), new FrameId("pioneer", "base_link"), RigidTransform.IDENTITY,
            Doubles.EMPTY,
            new Vector3(metresPerSecond, 0, 0), Vector3.ZERO, Doubles.EMPTY),
        Optional.empty(), clock.nanos(), Optional.empty());
  }

  @Override
  public SafetyConfig safety() {
    return safety;
  }

  @Override
  public void cancelCalls() {
    cancels.incrementAndGet();
  }

  @Override
  public void callStop() {
    stopCalls.incrementAndGet();
  }

  @Override
  public void changed() {
    // only the arbiter is of interest
  }

  @Override
  public void alert(String message) {
    alerts.add(message);
  }

  @Override
  public void close() {
    sender.close();
  }
}
