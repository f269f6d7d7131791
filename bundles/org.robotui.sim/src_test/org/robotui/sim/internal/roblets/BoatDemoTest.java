package org.robotui.sim.internal.roblets;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.net.InetAddress;
import java.net.InetSocketAddress;
import java.time.Duration;
import java.util.List;
import java.util.Set;
import java.util.concurrent.ThreadFactory;
import java.util.function.BooleanSupplier;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.robotui.net.socket.HostPort;
import org.robotui.roblets.body.BodySnapshot;
import org.robotui.roblets.roblet.RobletOptions;
import org.robotui.roblets.roblet.RobletRunner;
import org.robotui.roblets.tree.BodyElement;
import org.robotui.roblets.tree.BodyPath;
import org.robotui.roblets.watch.BodyWatchListener;
import org.robotui.roblets.watch.BodyWatcher;
import org.robotui.roblets.wire.RobletStatus;
import org.robotui.sim.internal.roblets.BoatMessages.Heading;

/** The boat with its roblets and its brain, over real datagrams. */
@Timeout(180)
class BoatDemoTest {
  private static final ThreadFactory THREADS = Thread.ofPlatform().daemon().factory();

  private final BoatDemo demo = BoatDemo.start(0, 1);

  BoatDemoTest() throws IOException {
    // it sails from its field on
  }

  @AfterEach
  void end() {
    demo.close();
  }

  private BodySnapshot body() {
    return demo.brain().bodymap().snapshot();
  }

  private double number(String path) {
    return body().number(BodyPath.parse(path)).orElse(Double.NaN);
  }

  private void await(String what, BooleanSupplier condition) {
    long end = System.nanoTime() + Duration.ofSeconds(90).toNanos();
    while (!condition.getAsBoolean()) {
      assertTrue(System.nanoTime() - end < 0, () -> what + ": " + body().tree());
      try {
        Thread.sleep(10);
      } catch (InterruptedException e) {
        throw new AssertionError(e);
      }
    }
  }

  private BodyWatcher watcher() throws IOException {
    return new BodyWatcher("me", new InetSocketAddress(InetAddress.getLoopbackAddress(), demo.brain().port()), THREADS,
        new BodyWatchListener() {});
  }

  @Test
  void it_sails_to_its_mark_and_is_steered_by_hand() throws IOException {
    await("it is under way to the north",
        () -> number("log/motion/@vx") > 0.5 && number("gps/position/@latitude") > 43.6);
    await("it steers", () -> Math.abs(number("rudder/turn/@angle")) > 0.1);
    try (BodyWatcher watcher = watcher()) {
      await("the helm is turned to port", () -> {
        watcher.ask("helm", BodyElement.of("velocity").with("vx", 0).with("vy", 0).with("wz", 0.3));
        return number("rudder/turn/@angle") < -30 && number("motor/power/@throttle") == 0;
      });
      await("nobody steers any more", () -> Math.abs(number("rudder/turn/@angle")) < 1
          && body().values(BodyPath.parse("helm/order/@autopilot")).equals(List.of("false")));
      await("the autopilot comes back where that is ordered", () -> {
        watcher.ask("helm", BodyElement.of("autopilot").with("on", true));
        return number("motor/power/@throttle") > 0.5;
      });
      assertEquals(Set.of("me"), demo.brain().watchers());
    }
  }

  @Test
  void another_compass_takes_the_place_of_one_and_nobody_else_notices() throws IOException {
    await("all are heard", () -> body().parts().size() == 9);
    int port = demo.brain().port();
    RobletOptions options = RobletOptions.of(THREADS, new HostPort("127.0.0.1", port));
    try (RobletRunner other =
        new RobletRunner(() -> CommonRoblets.compass(() -> new Heading(123, 0)), options)) {
      await("another one stands in its place", () -> number("compass/heading/@heading") == 123);
      assertEquals("compass", other.form().name());
    }
    List<RobletStatus> others =
        demo.brain().roblets().stream().filter(s -> !s.form().name().equals("compass")).toList();
    assertEquals(8, others.size());
    others.forEach(s -> assertTrue(s.tally().runs() == 1 && s.tally().late() == 0 && s.tally().doubled() == 0,
        s::toString));
  }
}
