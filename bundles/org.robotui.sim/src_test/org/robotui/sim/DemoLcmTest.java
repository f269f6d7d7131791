package org.robotui.sim;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertNotNull;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.ByteArrayInputStream;
import java.io.IOException;
import java.net.URI;
import java.nio.ByteBuffer;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.concurrent.BlockingQueue;
import java.util.concurrent.ConcurrentHashMap;
import java.util.concurrent.LinkedBlockingQueue;
import java.util.concurrent.TimeUnit;
import java.util.function.Predicate;
import javax.imageio.ImageIO;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.robotui.lcm.Lcm;
import org.robotui.lcm.LcmOptions;
import org.robotui.lcm.LcmState;
import org.robotui.lcm.LcmUrl;
import org.robotui.lcm.SubscriptionOptions;
import org.robotui.lcm.tcpq.TcpqServer;
import org.robotui.lcm.tcpq.TcpqServerOptions;
import org.robotui.lcm.type.LcmRecord;
import org.robotui.lcm.type.RecordException;
import org.robotui.lcm.type.TypeFolder;
import org.robotui.lcm.type.TypeLibrary;

/** The robots over LCM, heard by our client. Runs five times faster than real. */
class DemoLcmTest {
  private static final long PATIENCE = 20;

  private final TypeLibrary types = types();
  private final Map<String, BlockingQueue<LcmRecord>> heard = new ConcurrentHashMap<>();
  private final List<AutoCloseable> open = new ArrayList<>();
  private Demo demo;
  private Lcm client;

  private static TypeLibrary types() {
    try {
      return TypeFolder.read(List.of(LcmTypes.folder()));
    } catch (IOException e) {
      throw new AssertionError(e);
    }
  }

  private void start(String... more) throws Exception {
    List<String> arguments =
        new ArrayList<>(List.of("--speak", "lcm", "--lcm-types", LcmTypes.folder().toString(), "--speed-factor", "5"));
    arguments.addAll(List.of(more));
    demo = Demo.start(Options.parse(arguments));
    open.add(demo);
    client = Lcm.open(LcmUrl.of(demo.addresses().get("LCM_DEFAULT_URL")),
        LcmOptions.standard(task -> Thread.ofPlatform().daemon().unstarted(task)));
    open.add(client);
    client.subscribe("[A-Z_]+", SubscriptionOptions.direct(), message -> {
      try {
        heard.computeIfAbsent(message.channel(), none -> new LinkedBlockingQueue<>()).add(types.decode(message.data()));
      } catch (RecordException e) {
        throw new IllegalStateException(e);
      }
    });
    long end = System.nanoTime() + TimeUnit.SECONDS.toNanos(PATIENCE);
    while (!(client.state() instanceof LcmState.Connected)) {
      assertTrue(System.nanoTime() < end, () -> "the client is " + client.state());
      Thread.sleep(5);
    }
  }

  @AfterEach
  void end() throws Exception {
    for (AutoCloseable each : open.reversed()) {
      each.close();
    }
  }

  private LcmRecord await(String channel, Predicate<LcmRecord> wanted) throws InterruptedException {
    BlockingQueue<LcmRecord> queue = heard.computeIfAbsent(channel, none -> new LinkedBlockingQueue<>());
    long end = System.nanoTime() + TimeUnit.SECONDS.toNanos(PATIENCE);
    while (true) {
      LcmRecord record = queue.poll(end - System.nanoTime(), TimeUnit.NANOSECONDS);
      assertNotNull(record, "no such message on " + channel);
      if (wanted.test(record)) {
        return record;
      }
    }
  }

  private LcmRecord next(String channel) throws InterruptedException {
    return await(channel, any -> true);
  }

  private static double number(LcmRecord record, String path) {
    return record.number(path).orElseThrow(() -> new AssertionError(path + " of " + record));
  }

  private void send(String channel, LcmRecord record) throws IOException {
    client.publish(channel, types.type(record.type()).orElseThrow().encode(record));
  }

  private LcmRecord velocity(double linear, double angular) {
    return types.type("robotui.velocity_t").orElseThrow().builder().whole("utime", 1).numbers("linear", linear, 0, 0)
        .numbers("angular", 0, 0, angular).build();
  }

  private LcmRecord pose(String frame, double x, double y) {
    return types.type("robotui.pose_t").orElseThrow().builder().text("frame", frame).numbers("position", x, y, 0)
        .numbers("orientation", 1, 0, 0, 0).build();
  }

  private LcmRecord goal(String id, LcmRecord pose) {
    return types.type("robotui.goal_t").orElseThrow().builder().text("id", id).record("pose", pose).build();
  }

  @Test
  void natalieTellsWhatHerSensorsMeasure() throws Exception {
    start();
    long before = System.currentTimeMillis() * 1000 - 5_000_000;
    LcmRecord laser = next("LASER");
    assertEquals(361, laser.numbers("ranges").orElseThrow().size());
    assertEquals(-Math.PI / 2, number(laser, "angle_min"), 1e-9);
    assertTrue(number(laser, "utime") > before && number(laser, "utime") < before + 60e6,
        "utime " + number(laser, "utime"));
    LcmRecord sonar = next("SONAR");
    assertEquals(16, sonar.numbers("ranges").orElseThrow().size());
    assertEquals(Math.toRadians(50), number(sonar, "yaw[1]"), 1e-6);
    assertEquals(9.81, number(next("IMU"), "acceleration[2]"), 0.01);
    LcmRecord battery = next("BATTERY");
    assertEquals(0.87, number(battery, "level"), 0.03);
    assertEquals(number(battery, "level"), number(battery, "charge") / number(battery, "capacity"), 1e-9);
    LcmRecord picture = next("CAMERA");
    byte[] jpeg = new byte[(int) number(picture, "size")];
    picture.numbers("data").orElseThrow().bytes().get(jpeg);
    assertEquals(320, ImageIO.read(new ByteArrayInputStream(jpeg)).getWidth());
    LcmRecord transforms = next("TRANSFORMS");
    assertEquals("odom", transforms.text("transforms[0].child").orElseThrow());
    assertEquals(number(next("POSE"), "position[0]"),
        number(transforms, "transforms[0].position[0]") + number(next("ODOMETRY"), "position[0]"), 0.1);
    LcmRecord map = next("MAP");
    assertEquals(number(map, "width") * number(map, "height"), map.numbers("cells").orElseThrow().size());
  }

  @Test
  void aVelocityDrivesItForHalfASecond() throws Exception {
    start("--robot", "keira");
    send("VELOCITY", velocity(0.3, 0.5));
    await("ODOMETRY", odometry -> Math.abs(number(odometry, "linear_velocity[0]") - 0.3) < 1e-9);
    await("LOG", log -> log.text("text").orElseThrow().contains("timed out"));
    await("ODOMETRY", odometry -> number(odometry, "linear_velocity[0]") == 0);
    send("VELOCITY", velocity(Double.NaN, 0));
    client.publish("VELOCITY", ByteBuffer.wrap(new byte[20]));
    send("VELOCITY", velocity(0.2, 0));
    await("ODOMETRY", odometry -> Math.abs(number(odometry, "linear_velocity[0]") - 0.2) < 1e-9);
    assertEquals("[left, right]", next("BUMPER").at("names")
        .map(names -> ((org.robotui.lcm.type.LcmValue.Texts) names).values().toString()).orElseThrow());
  }

  @Test
  void aGoalIsReachedAndAnotherCancelled() throws Exception {
    start("--robot", "keira");
    send("GOAL", goal("first", pose("base", 1, 0)));
    await("GOAL_STATUS", status -> status.text("id").orElseThrow().equals("first") && number(status, "status") == 1);
    await("PATH", path -> number(path, "count") > 3);
    await("GOAL_STATUS", status -> number(status, "status") == 2);
    send("GOAL", goal("second", pose("map", 6, 5)));
    await("GOAL_STATUS", status -> status.text("id").orElseThrow().equals("second") && number(status, "status") == 1);
    send("CANCEL", types.type("robotui.cancel_t").orElseThrow().builder().text("id", "second").build());
    await("GOAL_STATUS", status -> number(status, "status") == 3);
    send("INITIAL_POSE", pose("map", 3, 3));
    await("POSE", at -> Math.hypot(number(at, "position[0]") - 3, number(at, "position[1]") - 3) < 0.05);
    send("MOTORS", types.type("robotui.motors_t").orElseThrow().builder().flag("on", false).build());
    await("LOG", log -> log.text("text").orElseThrow().equals("motors off"));
  }

  @Test
  void aNamespaceStandsBeforeAllChannels() throws Exception {
    start("--namespace", "team/keira");
    next("TEAM_KEIRA_POSE");
    assertTrue(heard.keySet().stream().filter(name -> !name.equals("ROBOTUI_PROBE"))
        .allMatch(name -> name.startsWith("TEAM_KEIRA_")), heard.keySet().toString());
  }

  @Test
  void aServerDoesAsWell() throws Exception {
    try (TcpqServer server =
        TcpqServer.open(TcpqServerOptions.loopback(task -> Thread.ofPlatform().daemon().unstarted(task), 0))) {
      String url = "tcpq://127.0.0.1:" + server.address().getPort();
      start("--lcm-url", url);
      assertEquals(URI.create(url), URI.create(demo.addresses().get("LCM_DEFAULT_URL")));
      next("LASER");
    }
  }

  @Test
  void whatIsMissingIsNamed(@TempDir Path empty) throws IOException {
    Files.writeString(empty.resolve("other_t.lcm"), "struct other_t { int32_t x; }");
    Options without = Options.parse(List.of("--speak", "lcm", "--lcm-types", empty.toString()));
    assertTrue(
        assertThrows(IllegalArgumentException.class, () -> Demo.start(without)).getMessage().contains("robotui."));
    Options nowhere = Options.parse(
        List.of("--speak", "lcm", "--lcm-types", LcmTypes.folder().toString(), "--lcm-url", "tcpq://127.0.0.1:1"));
    assertTrue(assertThrows(IOException.class, () -> Demo.start(nowhere)).getMessage().contains("127.0.0.1:1"));
  }
}
