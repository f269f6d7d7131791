package org.robotui.rfic.carmen.internal;

import static org.junit.jupiter.api.Assertions.assertInstanceOf;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.net.InetAddress;
import java.time.Duration;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.concurrent.Callable;
import java.util.concurrent.CopyOnWriteArrayList;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import org.robotui.api.Rfic;
import org.robotui.api.link.LinkState;
import org.robotui.api.port.CommandSink;
import org.robotui.api.port.CommandSink.Sent;
import org.robotui.carmen.central.CentralOptions;
import org.robotui.carmen.central.IpcCentral;
import org.robotui.carmen.message.IpcForms;
import org.robotui.carmen.module.IpcModule;
import org.robotui.carmen.module.MessageSender;
import org.robotui.carmen.module.ModuleOptions;
import org.robotui.data.Data;
import org.robotui.data.command.VelocityCommand;
import org.robotui.guard.Guards;
import org.robotui.net.socket.HostPort;
import org.robotui.testkit.FakeRficContext;
import org.robotui.testkit.rfic.Peer;

/** The central stays, and programs are started later and again: through the central, and directly. */
@Timeout(120)
class ProgramsComeAndGoTest {
  private static final IpcForms FORMS = IpcForms.carmen();

  private final FakeRficContext context = new FakeRficContext();

  /** A program that says odometry and hears velocities. */
  private record Program(IpcModule module, MessageSender odometry, List<Double> heard) {
    static Program start(IpcCentral central) throws IOException {
      IpcModule module = IpcModule.connect(new HostPort("127.0.0.1", central.port()), FORMS,
          ModuleOptions.of("robot", Peer.THREADS));
      List<Double> heard = new CopyOnWriteArrayList<>();
      module.subscribe(FORMS.get("carmen_robot_vel"), 1, (record, body) -> {
        heard.add(record.number("tv"));
        return Optional.empty();
      });
      return new Program(module, module.sender(FORMS.get("carmen_base_odometry")), heard);
    }

    boolean say(double x) throws IOException {
      odometry.refresh();
      return odometry.publish(odometry.form().make().number("x", x).number("timestamp", 1.7e9).build());
    }
  }

  @ParameterizedTest
  @ValueSource(booleans = {false, true})
  void a_program_that_is_started_again_is_heard_and_driven_again(boolean direct) throws Exception {
    try (IpcCentral central =
        new IpcCentral(new CentralOptions(Peer.THREADS, InetAddress.getLoopbackAddress(), 0, direct))) {
      Rfic rfic = CarmenSessions.rfic(context,
          CarmenPeer.settings(Map.of("host", "127.0.0.1", "port", (long) central.port())), new Guards());
      rfic.start();
      await("a central without programs is told",
          () -> context.links.peekLast() instanceof LinkState.Degraded d && d.reason().contains("no program"));
      Program first = Program.start(central);
      await("it is connected", () -> context.links.peekLast() instanceof LinkState.Connected);
      context.demand("base_odometry", true);
      await("it is heard", () -> first.say(1) && said() >= 1);
      await("it is driven", () -> drive() instanceof Sent.Out && !first.heard().isEmpty());
      first.module().close();
      await("nobody is driven", () -> drive() instanceof Sent.Refused);
      Program second = Program.start(central);
      int before = said();
      await("it is heard again", () -> second.say(2) && said() > before);
      await("it is driven again", () -> drive() instanceof Sent.Out && !second.heard().isEmpty());
      rfic.close();
      second.module().close();
      assertInstanceOf(LinkState.Disconnected.class, context.links.getLast());
    }
  }

  private int said() {
    return Optional.ofNullable(context.published.get("base_odometry")).map(d -> d.size()).orElse(0);
  }

  @SuppressWarnings("unchecked")
  private Sent drive() {
    CommandSink<Data> sink = (CommandSink<Data>) context.sinks.get("velocity");
    return sink == null ? new Sent.Refused("not offered") : sink.send(VelocityCommand.planar(0.2, 0));
  }

  private void await(String what, Callable<Boolean> condition) throws Exception {
    long end = System.nanoTime() + Duration.ofSeconds(60).toNanos();
    while (!condition.call()) {
      assertTrue(System.nanoTime() < end, () -> what + "; " + context.links);
      Thread.sleep(20);
    }
  }
}
