package org.robotui.rfic.lcm.internal;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertInstanceOf;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.net.InetAddress;
import java.net.ServerSocket;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.Duration;
import java.util.List;
import java.util.Map;
import java.util.Queue;
import java.util.concurrent.ConcurrentLinkedQueue;
import java.util.concurrent.ThreadFactory;
import java.util.concurrent.locks.LockSupport;
import java.util.function.BooleanSupplier;
import java.util.Deque;
import java.util.Optional;
import java.util.concurrent.ConcurrentLinkedDeque;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.robotui.api.Rfic;
import org.robotui.api.link.LinkState;
import org.robotui.api.port.Browser;
import org.robotui.api.port.CallException;
import org.robotui.api.port.CommandSink;
import org.robotui.api.port.CommandSink.Sent;
import org.robotui.api.port.RawMessage;
import org.robotui.data.Data;
import org.robotui.data.FrameId;
import org.robotui.data.array.Bytes;
import org.robotui.data.command.MessageCommand;
import org.robotui.data.command.RelayMessage;
import org.robotui.data.command.VelocityCommand;
import org.robotui.data.navigation.NavigationGoal;
import org.robotui.data.record.DynamicRecord;
import org.robotui.data.record.FieldPath;
import org.robotui.data.record.FieldValue;
import org.robotui.data.record.MapRecord;
import org.robotui.data.sensor.Battery;
import org.robotui.geometry.RigidTransform;
import org.robotui.guard.Guards;
import org.robotui.lcm.Lcm;
import org.robotui.lcm.LcmMessage;
import org.robotui.lcm.LcmOptions;
import org.robotui.lcm.LcmState;
import org.robotui.lcm.LcmUrl;
import org.robotui.lcm.SubscriptionOptions;
import org.robotui.lcm.tcpq.TcpqServer;
import org.robotui.lcm.tcpq.TcpqServerOptions;
import org.robotui.lcm.type.LcmRecord;
import org.robotui.lcm.type.TypeFolder;
import org.robotui.lcm.type.TypeLibrary;
import org.robotui.rfic.lcm.internal.convert.RecordFiller;
import org.robotui.testkit.FakeRficContext;

/** A robot behind a server, and an interface to it. */
class LcmRficTest {
  private static final Duration PATIENCE = Duration.ofSeconds(60);
  private static final ThreadFactory DAEMONS = Thread.ofPlatform().daemon().factory();

  private final FakeRficContext context = new FakeRficContext();
  private final Queue<LcmMessage> toRobot = new ConcurrentLinkedQueue<>();
  private TypeLibrary types;
  private TcpqServer server;
  private Lcm robot;
  private Rfic rfic;
  private String url;

  @BeforeEach
  void openRobot() throws IOException {
    types = TypeFolder.read(List.of(Written.types()));
    int port;
    try (ServerSocket free = new ServerSocket(0, 1, InetAddress.getLoopbackAddress())) {
      port = free.getLocalPort();
    }
    server = TcpqServer.open(TcpqServerOptions.loopback(DAEMONS, port));
    url = "tcpq://127.0.0.1:" + port;
    robot = Lcm.open(LcmUrl.of(url), LcmOptions.standard(DAEMONS));
    robot.subscribe("VELOCITY|GOAL|SAY|MOTORS", SubscriptionOptions.direct(), toRobot::add);
    await(() -> robot.state() instanceof LcmState.Connected);
    rfic = LcmSessions.rfic(context, Written.right(Written.settings(url, Written.types().toString(),
        Map.of("BATTERY", "battery", "ODOMETRY", "odometry", "TRANSFORMS", "transforms"),
        Map.of("VELOCITY", Written.map("as", "velocity", "type", "robotui.velocity_t"),
            "GOAL", Written.map("as", "goal", "type", "robotui.goal_t", "position", "pose.position", "orientation",
                "pose.orientation", "set", Map.of("id", "ui"))))),
        new Guards());
    rfic.start();
    await(() -> context.browsers.containsKey("channels"));
  }

  @AfterEach
  void closeAll() {
    long before = System.nanoTime();
    rfic.close();
    assertTrue(System.nanoTime() - before < Duration.ofSeconds(10).toNanos(), "closing took long");
    await(() -> context.threads.stream().noneMatch(Thread::isAlive));
    robot.close();
    server.close();
  }

  private static void await(BooleanSupplier condition) {
    long end = System.nanoTime() + PATIENCE.toNanos();
    while (!condition.getAsBoolean()) {
      assertTrue(System.nanoTime() < end, "waited in vain");
      LockSupport.parkNanos(5_000_000);
    }
  }

  private void say(String channel, String type, Map<String, Object> fields) {
    try {
      var known = types.type(type).orElseThrow();
      robot.publish(channel, known.encode(new RecordFiller(types).fill(known, fields)));
    } catch (IOException e) {
      throw new AssertionError(e);
    }
  }

  private void sayUntil(String channel, String type, Map<String, Object> fields, BooleanSupplier heard) {
    await(() -> {
      say(channel, type, fields);
      return heard.getAsBoolean();
    });
  }

  @SuppressWarnings("unchecked")
  private Sent send(String port, Data command) {
    return ((CommandSink<Data>) context.sinks.get(port)).send(command);
  }

  private LcmRecord received() throws Exception {
    await(() -> !toRobot.isEmpty());
    return types.decode(toRobot.remove().data());
  }

  @Test
  void mappedChannelsAreOfferedFromTheBeginningAndFedOnDemand() {
    assertEquals(Battery.class, context.streams.get("BATTERY").type());
    sayUntil("BATTERY", "robotui.battery_t", Map.of("voltage", 11.0),
        () -> context.links.peekLast() instanceof LinkState.Connected);
    assertTrue(context.published.get("BATTERY").isEmpty(), "nobody asked for it");
    context.demand("BATTERY", true);
    sayUntil("BATTERY", "robotui.battery_t", Map.of("utime", 7, "voltage", 12.5),
        () -> context.published.get("BATTERY").stream().anyMatch(p -> ((Battery) p.value()).voltage() == 12.5));
    FakeRficContext.Published first = context.published.get("BATTERY").getLast();
    assertEquals(7000, first.stamp().orElseThrow().nanos());
    DynamicRecord record = first.raw().orElseThrow().record().orElseThrow();
    assertEquals("robotui.battery_t", record.schema());
    assertEquals(12.5, ((FieldValue.Num) record.field("voltage").orElseThrow()).value());
  }

  @Test
  void framesAreFollowedAlsoWhileNobodyLooksAtTheirChannel() {
    sayUntil("TRANSFORMS", "robotui.transforms_t",
        Map.of("transforms", List.of(Map.of("parent", "odom", "child", "base"))), () -> !context.transforms.isEmpty());
    assertEquals("base", context.transforms.getFirst().child().name());
  }

  @Test
  void channelsThatAreNotMappedBecomeRecords() {
    sayUntil("MAP", "robotui.map_t", Map.of("resolution", 1.0), () -> context.streams.containsKey("MAP"));
    assertEquals("MAP, robotui.map_t", context.streams.get("MAP").help());
    context.demand("MAP", true);
    sayUntil("MAP", "robotui.map_t", Map.of("cells", List.of(List.of(1, 2), List.of(3, 4))),
        () -> context.published.get("MAP").stream().anyMatch(p -> cell((DynamicRecord) p.value()) == 3));
  }

  private static double cell(DynamicRecord record) {
    return record.at(FieldPath.parse("cells[1][0]")).map(v -> ((FieldValue.Num) v).value()).orElse(Double.NaN);
  }

  @Test
  void unknownTypesAreBytesWithARemedy() throws Exception {
    byte[] message = {1, 2, 3, 4, 5, 6, 7, 8, 9};
    await(() -> {
      publish("ODD", message);
      return context.streams.containsKey("ODD");
    });
    context.demand("ODD", true);
    await(() -> {
      publish("ODD", message);
      return !context.published.get("ODD").isEmpty();
    });
    DynamicRecord record = (DynamicRecord) context.published.get("ODD").getFirst().value();
    assertEquals(new FieldValue.Text("0x0102030405060708"), record.field("fingerprint").orElseThrow());
    assertEquals(9, ((FieldValue.Num) record.field("size").orElseThrow()).value());
    assertTrue(
        record.field("remedy").orElseThrow().toString().contains("add the .lcm file that its sender was built with"));
    Browser browser = context.browsers.get("channels");
    Browser.Item item =
        browser.list(Browser.Kind.TOPIC).stream().filter(i -> i.name().equals("ODD")).findFirst().orElseThrow();
    assertEquals("unknown type 0x0102030405060708", item.type());
    assertTrue(browser.describe(item).facts().get("problem").contains("has the fingerprint 0x0102030405060708"));
  }

  @Test
  void typesThatAreAddedWhileItRunsAreTakenUp(@TempDir Path folder) throws Exception {
    FakeRficContext later = new FakeRficContext();
    Rfic second = LcmSessions.rfic(later, Written.right(Written.settings(url, folder.toString(), Map.of(), Map.of())),
        new Guards());
    second.start();
    try {
      sayUntil("POWER", "robotui.battery_t", Map.of("voltage", 11.0),
          () -> typeOf(later, "POWER").startsWith("unknown type"));
      for (Path file : Files.list(Written.types().resolve("robotui")).toList()) {
        Files.copy(file, folder.resolve(file.getFileName().toString()));
      }
      sayUntil("POWER", "robotui.battery_t", Map.of("voltage", 11.0),
          () -> typeOf(later, "POWER").equals("robotui.battery_t"));
    } finally {
      second.close();
    }
    await(() -> later.threads.stream().noneMatch(Thread::isAlive));
  }

  private static String typeOf(FakeRficContext context, String channel) {
    try {
      Browser browser = context.browsers.get("channels");
      List<Browser.Item> items = browser == null ? List.of() : browser.list(Browser.Kind.TOPIC);
      return items.stream().filter(item -> item.name().equals(channel)).map(Browser.Item::type).findFirst().orElse("");
    } catch (CallException e) {
      throw new AssertionError(e);
    }
  }

  private void publish(String channel, byte[] message) {
    try {
      robot.publish(channel, ByteBuffer.wrap(message));
    } catch (IOException e) {
      throw new AssertionError(e);
    }
  }

  @Test
  void damagedMessagesNameChannelTypeAndPlace() {
    context.demand("BATTERY", true);
    ByteBuffer whole = types.type("robotui.battery_t").orElseThrow()
        .encode(types.type("robotui.battery_t").orElseThrow().builder().build());
    byte[] cut = new byte[whole.remaining() - 4];
    whole.get(cut);
    await(() -> {
      publish("BATTERY", cut);
      return !context.complaints.get("BATTERY").stream().filter(c -> !c.isEmpty()).toList().isEmpty();
    });
    String complaint = context.complaints.get("BATTERY").stream().filter(c -> !c.isEmpty()).findFirst().orElseThrow();
    assertTrue(complaint.contains("BATTERY from ") && complaint.contains("robotui.battery_t: ")
        && complaint.contains("member capacity"), complaint);
  }

  @Test
  void aChannelOfAnotherTypeIsSaidWithItsPlace() {
    context.demand("ODOMETRY", true);
    sayUntil("ODOMETRY", "robotui.battery_t", Map.of(), () -> context.links.peekLast() instanceof LinkState.Degraded d
        && d.reason().startsWith("robot.yaml:1") && d.reason().contains("ODOMETRY as odometry needs 'position'"));
  }

  @Test
  void commandsGoOutInTheTypeOfTheRobot() throws Exception {
    await(() -> send("VELOCITY", VelocityCommand.planar(0.5, -0.25)) instanceof Sent.Out);
    LcmRecord velocity = received();
    assertEquals(0.5, velocity.number("linear[0]").orElseThrow());
    assertEquals(-0.25, velocity.number("angular[2]").orElseThrow());
    assertTrue(Math.abs(velocity.number("utime").orElseThrow() / 1e3 - System.currentTimeMillis()) < 60_000);
    send("GOAL", new NavigationGoal(new FrameId("robby", "map"), RigidTransform.planar(1, 2, Math.PI)));
    LcmRecord goal = received();
    assertEquals("map", goal.text("pose.frame").orElseThrow());
    assertEquals("ui", goal.text("id").orElseThrow());
    assertEquals(2, goal.number("pose.position[1]").orElseThrow());
    assertEquals(1, Math.abs(goal.number("pose.orientation[3]").orElseThrow()), 1e-9);
  }

  @Test
  void singleMessagesAreSaidButDoNotMoveTheRobot() throws Exception {
    await(() -> send("publish",
        new MessageCommand("MOTORS", "robotui.motors_t", Map.of("on", true))) instanceof Sent.Out);
    assertEquals(1, received().number("on").orElseThrow());
    assertRefused("moves the robot", new MessageCommand("VELOCITY", "robotui.velocity_t", Map.of()));
    assertRefused("declares the type", new MessageCommand("SAY", "robotui.word_t", Map.of()));
    assertRefused("has no member 'onn'", new MessageCommand("MOTORS", "robotui.motors_t", Map.of("onn", true)));
    sayUntil("LOG", "robotui.log_t", Map.of(), () -> context.streams.containsKey("LOG"));
    assertRefused("LOG carries robotui.log_t", new MessageCommand("LOG", "robotui.motors_t", Map.of()));
  }

  @Test
  void whatOtherRobotsSayBecomesMessagesOfChannels() throws Exception {
    MapRecord fields = new MapRecord("robotui.motors_t", Map.of("on", new FieldValue.Num(1, "1")));
    await(() -> relay("MOTORS", fields).isEmpty());
    assertEquals(1, received().number("on").orElseThrow());
    assertTrue(relay("VELOCITY", new MapRecord("robotui.velocity_t", Map.of())).orElseThrow()
        .contains("moves the robot"));
    assertTrue(relay("FAR", new Battery(12, 0, 0.5, Battery.Status.FULL)).orElseThrow()
        .contains("with 'type', and its fields with 'fields'"));
  }

  /** The record says something else, so that it is seen of which of both the message was made. */
  @Test
  void bytesArriveAsTheyWereSentWhereTheFingerprintIsTheSame() throws Exception {
    context.demand("BATTERY", true);
    sayUntil("BATTERY", "robotui.battery_t", Map.of("utime", 7, "voltage", 12.5),
        () -> !context.published.get("BATTERY").isEmpty());
    RawMessage came = context.published.get("BATTERY").getFirst().raw().orElseThrow();
    MapRecord record = new MapRecord("robotui.battery_t", Map.of("voltage", new FieldValue.Num(3, "3")));
    await(() -> relay("SAY", record, asItCame(came.encoding(), came.bytes())).isEmpty());
    await(() -> !toRobot.isEmpty());
    assertEquals(came.bytes().buffer(ByteOrder.BIG_ENDIAN), toRobot.remove().data());

    byte[] other = new byte[came.bytes().size()];
    came.bytes().copyTo(0, other, 0, other.length);
    other[0]++;
    await(() -> relay("SAY", record, asItCame(came.encoding(), Bytes.of(other))).isEmpty());
    await(() -> !toRobot.isEmpty());
    assertEquals(3, types.decode(toRobot.remove().data()).number("voltage").orElse(-1), "another type is made anew");
  }

  private static RelayMessage.Original asItCame(String encoding, Bytes bytes) {
    return new RelayMessage.Original("robotui.battery_t", Optional::empty,
        Optional.of(new RelayMessage.Wire(encoding, Optional::empty, bytes)));
  }

  /** Why it was not said; what became of it is told besides. */
  private Optional<String> relay(String channel, Data value) {
    return relay(channel, value, RelayMessage.Original.NONE);
  }

  private Optional<String> relay(String channel, Data value, RelayMessage.Original original) {
    Deque<Optional<String>> told = new ConcurrentLinkedDeque<>();
    Sent sent =
        send("relay", new RelayMessage(channel, "", value, Optional.empty(), original, false, false, told::add));
    Optional<String> refusal = sent instanceof Sent.Refused refused ? Optional.of(refused.reason()) : Optional.empty();
    assertEquals(List.of(refusal), List.copyOf(told));
    return refusal;
  }

  private void assertRefused(String part, MessageCommand command) {
    String reason = assertInstanceOf(Sent.Refused.class, send("publish", command)).reason();
    assertTrue(reason.contains(part), reason);
  }

  @Test
  void nothingIsSentWhileTheServerIsAway() {
    await(() -> send("VELOCITY", VelocityCommand.ZERO) instanceof Sent.Out);
    server.close();
    await(() -> context.links.peekLast() instanceof LinkState.Failed);
    String reason = assertInstanceOf(Sent.Refused.class, send("VELOCITY", VelocityCommand.ZERO)).reason();
    assertTrue(reason.contains("no connection"), reason);
  }

  @Test
  void aSilentRobotIsNotGreen() {
    await(() -> context.links.peekLast() instanceof LinkState.Degraded d
        && d.reason().contains("nobody has sent anything yet"));
    sayUntil("BATTERY", "robotui.battery_t", Map.of(), () -> context.links.peekLast() instanceof LinkState.Connected);
  }
}
