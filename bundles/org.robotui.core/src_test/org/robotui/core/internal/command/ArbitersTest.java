package org.robotui.core.internal.command;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertSame;

import java.util.List;
import java.util.Optional;
import java.util.concurrent.CopyOnWriteArrayList;
import org.junit.jupiter.api.Test;
import org.robotui.api.link.LinkState;
import org.robotui.api.port.CommandSink;
import org.robotui.api.port.SourceId;
import org.robotui.core.internal.config.model.SafetyConfig;
import org.robotui.core.internal.port.Link;
import org.robotui.core.internal.port.StreamSource;
import org.robotui.core.internal.support.Await;
import org.robotui.core.internal.support.CoreBench;
import org.robotui.core.internal.support.Samples;
import org.robotui.core.internal.time.NanoClock;
import org.robotui.data.command.VelocityCommand;

class ArbitersTest {
  private final DisplayWatch display = new DisplayWatch(NanoClock.SYSTEM);
  private final Arbiters arbiters = new Arbiters(NanoClock.SYSTEM, display);

  private record Ports(List<CommandTarget<?>> commands) implements RobotPorts {
    @Override
    public List<StreamSource<?>> streams() {
      return List.of();
    }

    @Override
    public SafetyConfig safety() {
      return SafetyConfig.DEFAULT;
    }

    @Override
    public void cancelCalls() {
      // there are none
    }

    @Override
    public void callStop() {
      // there is none
    }

    @Override
    public void changed() {
      // nobody listens
    }

    @Override
    public void alert(String message) {
      throw new AssertionError(message);
    }
  }

  @Test
  void oneRobotInTwoRuicsHasOneArbiterAndOneThread() {
    Ports first = new Ports(List.of());
    Ports second = new Ports(List.of());
    arbiters.register("twice", first);
    arbiters.register("twice", second);
    assertSame(arbiters.of("twice"), arbiters.of("twice"));
    assertEquals(List.of("arbiter-twice"), CoreBench.threads("arbiter-twice"));
    arbiters.unregister("twice", first);
    assertEquals(List.of("arbiter-twice"), CoreBench.threads("arbiter-twice"));
    arbiters.unregister("twice", second);
    Await.until("its thread has ended", () -> CoreBench.threads("arbiter-twice").isEmpty());
  }

  @Test
  void stopStaysLatchedWhileNoRuicHasTheRobot() {
    Ports ports = new Ports(List.of());
    arbiters.register("latched", ports);
    arbiters.stopAll(Samples.YOU);
    arbiters.unregister("latched", ports);
    assertEquals(Optional.of(Samples.YOU), arbiters.of("latched").stoppedBy());
    arbiters.close();
  }

  @Test
  void stopWorksWhileTheDisplayThreadHangs() {
    List<VelocityCommand> sent = new CopyOnWriteArrayList<>();
    Link link = new Link(NanoClock.SYSTEM, () -> {});
    link.report(new LinkState.Connected("robot"));
    Sender sender = new Sender("base", Thread.ofPlatform().daemon().factory(), NanoClock.SYSTEM);
    CommandTarget<VelocityCommand> target =
        new CommandTarget<>(new SourceId("base", "cmd_vel"), Samples.VELOCITY, c -> {
          sent.add(c);
          return new CommandSink.Sent.Out();
        }, link, arbiters.of("hung"), sender, NanoClock.SYSTEM, o -> {});
    Ports ports = new Ports(List.of(target));
    arbiters.register("hung", ports);
    display.alive(); // and never again
    arbiters.of("hung").stop(Samples.YOU);
    Await.until("zero is said", () -> sent.contains(VelocityCommand.ZERO));
    arbiters.unregister("hung", ports);
    sender.close();
  }
}
