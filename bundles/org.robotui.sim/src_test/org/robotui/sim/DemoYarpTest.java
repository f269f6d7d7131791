package org.robotui.sim;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertNotNull;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.net.InetAddress;
import java.time.Duration;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.concurrent.BlockingQueue;
import java.util.concurrent.ConcurrentHashMap;
import java.util.concurrent.LinkedBlockingQueue;
import java.util.concurrent.TimeUnit;
import java.util.function.Predicate;
import javax.net.SocketFactory;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.robotui.net.call.Outcome;
import org.robotui.net.socket.HostPort;
import org.robotui.yarp.bottle.Bottle;
import org.robotui.yarp.bottle.BottleText;
import org.robotui.yarp.image.YarpImage;
import org.robotui.yarp.name.NameClient;
import org.robotui.yarp.port.PortAdmin;
import org.robotui.yarp.port.PortCall;
import org.robotui.yarp.port.PortOptions;
import org.robotui.yarp.port.YarpPort;
import org.robotui.yarp.wire.YarpCarrier;

/** The simulated robots as devices of YARP, seen by a port of ours. */
@Timeout(120)
class DemoYarpTest {
  private static final Duration PATIENCE = Duration.ofSeconds(60);

  private final PortOptions options =
      new PortOptions(Thread.ofPlatform().daemon().factory(), SocketFactory.getDefault(), PATIENCE);
  private final Map<String, BlockingQueue<Bottle>> heard = new ConcurrentHashMap<>();
  private Demo demo;
  private NameClient names;
  private YarpPort port;

  private void start(String robot) throws IOException {
    demo = Demo.start(Options.parse(List.of("--robot", robot, "--speak", "yarp")));
    String server = demo.addresses().get("YARP_NAMESERVER");
    names = new NameClient(HostPort.ofUri("yarp://" + server, "yarp"), SocketFactory.getDefault(), PATIENCE);
    port = new YarpPort("/test", InetAddress.getLoopbackAddress(), 0, Optional.of(names), arrival -> {
      queue(arrival.from()).add(arrival.bottle());
      return Optional.empty();
    }, options);
    names.register(port.name(), new HostPort("127.0.0.1", port.port()), YarpPort.ACCEPTS);
  }

  private BlockingQueue<Bottle> queue(String name) {
    return heard.computeIfAbsent(name, n -> new LinkedBlockingQueue<>());
  }

  @AfterEach
  void end() {
    port.close();
    demo.close();
  }

  private HostPort where(String name) throws IOException {
    return names.query(name).orElseThrow(() -> new AssertionError("no port " + name)).where();
  }

  private Bottle await(String name, Predicate<Bottle> wanted) throws Exception {
    if (!port.sources().contains(name)) {
      Outcome<String> outcome = new PortAdmin(options).connect(where(name), YarpCarrier.FAST_TCP, port.name());
      assertTrue(outcome instanceof Outcome.Done, outcome::reason);
    }
    long end = System.nanoTime() + PATIENCE.toNanos();
    while (true) {
      Bottle bottle = queue(name).poll(end - System.nanoTime(), TimeUnit.NANOSECONDS);
      assertNotNull(bottle, "no such " + name);
      if (wanted.test(bottle)) {
        return bottle;
      }
    }
  }

  @Test
  void natalieTellsWhatSheMeasuresAndIsDriven() throws Exception {
    start("natalie");
    Bottle scan = await("/natalie/laser", any -> true);
    assertEquals(361, scan.get(4).items().size());
    assertEquals(-90, scan.get(0).number(), 1e-6);
    assertEquals(10, await("/natalie/imu/measures:o", any -> true).size());
    port.connect("/natalie/base/data:i", where("/natalie/base/data:i"), YarpCarrier.TCP);
    await("/natalie/odo/odometry:o", m -> {
      port.say(Bottle.reals(0.2, 0, 10), Optional.empty());
      return m.get(3).number() > 0.15 && m.get(5).number() > 5;
    });
    await("/natalie/odo/odometry:o", m -> m.get(3).number() == 0);
    YarpImage picture = YarpImage.read(await("/natalie/camera", any -> true));
    assertEquals("rgb", picture.pixels());
  }

  @Test
  void aHeadIsAControlBoard() throws Exception {
    start("natalie");
    String name = "natalie";
    try (PortCall call = PortCall.connect(where("/" + name + "/head/rpc:i"), "/test/rpc", options)) {
      assertEquals(2, ask(call, "[get] [axes]").get(2).number());
      assertEquals("neck_tilt", ask(call, "[get] [name] 1").get(2).text());
      assertEquals("fail", ask(call, "[set] [vmo] 0 10.0").get(0).text());
      assertEquals("ok", ask(call, "set icmd cmod 0 pos").get(0).text());
      assertEquals("ok", ask(call, "[set] [pos] 0 20.0").get(0).text());
      await("/" + name + "/head/stateExt:o", m -> Math.abs(m.get(0).items().get(0).number() - 20) < 0.5);
      assertEquals(20, ask(call, "[get] [enc] 0").get(2).number(), 0.5);
      assertEquals("ok", ask(call, "[set] [icmd] [cmod] 1 [vel]").get(0).text());
      assertEquals("ok", ask(call, "[set] [vmo] 1 5.0").get(0).text());
      assertEquals("ok", ask(call, "[set] [sto] 1").get(0).text());
    }
  }

  private static Bottle ask(PortCall call, String question) throws IOException {
    return call.ask(BottleText.parse(question), PATIENCE).toOptional().orElseThrow();
  }
}
