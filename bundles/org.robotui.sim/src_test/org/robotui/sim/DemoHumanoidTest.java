package org.robotui.sim;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.file.Path;
import java.time.Duration;
import java.util.List;
import java.util.Set;
import java.util.function.BooleanSupplier;
import java.util.stream.Collectors;
import javax.net.SocketFactory;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.robotui.net.socket.HostPort;
import org.robotui.sim.internal.yarp.HumanoidDemo;
import org.robotui.yarp.bottle.Bottle;
import org.robotui.yarp.bottle.BottleText;
import org.robotui.yarp.name.NameClient;
import org.robotui.yarp.name.YarpAddress;
import org.robotui.yarp.port.PortCall;
import org.robotui.yarp.port.PortOptions;

/** The humanoid as control boards, asked by a client of ours. */
@Timeout(120)
class DemoHumanoidTest {
  private static final Duration PATIENCE = Duration.ofSeconds(30);

  private final PortOptions options =
      new PortOptions(Thread.ofPlatform().daemon().factory(), SocketFactory.getDefault(), PATIENCE);
  private HumanoidDemo demo;
  private NameClient names;

  @BeforeEach
  void start() throws IOException {
    Path urdf = LcmTypes.folder().resolve("../../humanoid/humanoid.urdf").normalize();
    Options read = Options.parse(List.of("--humanoid", "--urdf", urdf.toString()));
    demo = HumanoidDemo.start(read.humanoid().orElseThrow(), 0);
    names = new NameClient(HostPort.ofUri("yarp://" + demo.address(), "yarp"), SocketFactory.getDefault(), PATIENCE);
  }

  @AfterEach
  void end() {
    demo.close();
  }

  private PortCall board(String part) throws IOException {
    return PortCall.connect(names.query("/humanoid/" + part + "/rpc:i").orElseThrow().where(), "/test/" + part,
        options);
  }

  private static Bottle ask(PortCall call, String question) {
    try {
      return call.ask(BottleText.parse(question), PATIENCE).toOptional().orElseThrow();
    } catch (IOException e) {
      throw new AssertionError(e);
    }
  }

  private static double position(PortCall call, int joint) {
    return ask(call, "[get] [enc] " + joint).get(2).number();
  }

  private static void await(String what, BooleanSupplier condition) throws InterruptedException {
    long end = System.nanoTime() + PATIENCE.toNanos();
    while (!condition.getAsBoolean()) {
      assertTrue(System.nanoTime() - end < 0, what);
      Thread.sleep(10);
    }
  }

  @Test
  void each_part_is_a_control_board_with_the_joints_of_the_model() throws Exception {
    Set<String> ports = names.list().stream().map(YarpAddress::name).collect(Collectors.toSet());
    for (String part : List.of("head", "torso", "left_arm", "right_arm", "left_leg", "right_leg")) {
      for (String port : List.of("state:o", "stateExt:o", "command:i", "rpc:i")) {
        assertTrue(ports.contains("/humanoid/" + part + "/" + port), () -> part + "/" + port + " of " + ports);
      }
    }
    try (PortCall arm = board("left_arm")) {
      assertEquals(7, ask(arm, "[get] [axes]").get(2).number());
      assertEquals("left_elbow", ask(arm, "[get] [name] 3").get(2).text());
      Bottle limits = ask(arm, "[get] [llim] 3");
      assertTrue(limits.get(2).number() < limits.get(3).number());
    }
  }

  @Test
  void joints_sway_until_they_are_driven_by_positions_or_velocities() throws Exception {
    try (PortCall head = board("head")) {
      double first = position(head, 0);
      await("it sways", () -> Math.abs(position(head, 0) - first) > 1);
      assertEquals("ok", ask(head, "[set] [poss] (20.0 5.0)").get(0).text());
      await("it is there", () -> Math.abs(position(head, 0) - 20) < 0.1 && Math.abs(position(head, 1) - 5) < 0.1);
      assertEquals("fail", ask(head, "[set] [vmo] 0 -8.0").get(0).text(), "not in the mode for positions");
      assertEquals("ok", ask(head, "[set] [icmd] [cmod] 0 [vel]").get(0).text());
      assertEquals("vel", ask(head, "[get] [icmd] [cmod] 0").get(2).text());
      assertEquals("ok", ask(head, "[set] [vmo] 0 -8.0").get(0).text());
      await("it turns", () -> position(head, 0) < 15);
      assertEquals("ok", ask(head, "[set] [stos]").get(0).text());
      double stopped = position(head, 0);
      assertEquals(stopped, position(head, 0), 1e-6, "it stands");
      assertEquals("fail", ask(head, "[set] [pos] 7 1.0").get(0).text(), "there is no such joint");
    }
  }
}
