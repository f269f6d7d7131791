package org.robotui.core.internal.command;

import java.time.Duration;
import java.util.List;
import java.util.Optional;
import java.util.concurrent.CountDownLatch;
import java.util.concurrent.TimeUnit;
import org.robotui.api.command.Principal;
import org.robotui.api.link.LinkState;
import org.robotui.api.port.Arity;
import org.robotui.api.port.CommandPort;
import org.robotui.api.port.CommandSink;
import org.robotui.api.port.SourceId;
import org.robotui.core.internal.config.model.SafetyConfig;
import org.robotui.core.internal.port.Link;
import org.robotui.core.internal.port.StreamSource;
import org.robotui.core.internal.time.NanoClock;
import org.robotui.data.command.MotionLimits;
import org.robotui.data.command.VelocityCommand;

/**
 * Drives and stops a robot that does not exist. Code that runs for the first time is loaded and linked, which needs
 * more memory than is left when all robots are stopped because the memory is used up. So what stops them has run
 * before.
 */
public final class StopWarmUp implements RobotPorts {
  private static final Principal BY = new Principal("core", "RobotUI", Principal.Kind.SCRIPT);
  private static final Duration LONG = Duration.ofMinutes(1);
  private static final SourceId PORT = new SourceId("warm-up", "cmd_vel");

  private final NanoClock clock = NanoClock.SYSTEM;
  private final Arbiters arbiters = new Arbiters(clock, new DisplayWatch(clock));
  private final Arbiter arbiter = arbiters.of(PORT.component());
  private final Sender sender = new Sender(PORT.component(), Thread.ofPlatform().daemon().factory(), clock);
  private final CountDownLatch stopped = new CountDownLatch(1);
  private final CommandTarget<VelocityCommand> target;

  private StopWarmUp() {
    Link link = new Link(clock, arbiter::recheck);
    link.report(new LinkState.Connected(PORT.component()));
    CommandPort<VelocityCommand> port = new CommandPort<>(PORT.port(), VelocityCommand.class, Arity.MANY, "");
    target = new CommandTarget<>(PORT, port, this::take, link, arbiter, sender, clock, gone -> {});
  }

  /**
   * Does so on the calling thread, in milliseconds.
   *
   * @return whether the robot that does not exist was stopped; false where the thread was interrupted
   */
  public static boolean run() {
    StopWarmUp robot = new StopWarmUp();
    try {
      return robot.stop();
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
      return false;
    } finally {
      robot.end();
    }
  }

  private boolean stop() throws InterruptedException {
    arbiters.register(PORT.component(), this);
    arbiter.send(this, BY, target, VelocityCommand.planar(1, 0), LONG);
    arbiters.stopAll(BY);
    return stopped.await(LONG.toSeconds(), TimeUnit.SECONDS);
  }

  private void end() {
    target.close();
    arbiters.unregister(PORT.component(), this);
    arbiters.close();
    sender.close();
  }

  private CommandSink.Sent take(VelocityCommand command) {
    if (command.equals(VelocityCommand.ZERO)) {
      stopped.countDown();
    }
    return new CommandSink.Sent.Out();
  }

  @Override
  public List<CommandTarget<?>> commands() {
    return List.of(target);
  }

  @Override
  public List<StreamSource<?>> streams() {
    return List.of();
  }

  @Override
  public SafetyConfig safety() {
    return new SafetyConfig(MotionLimits.NONE, Optional.empty(), false);
  }

  @Override
  public void cancelCalls() {
    // It takes no calls.
  }

  @Override
  public void callStop() {
    // It takes no calls.
  }

  @Override
  public void changed() {
    // Nobody looks at it.
  }

  @Override
  public void alert(String message) {
    // Nobody looks at it.
  }
}
