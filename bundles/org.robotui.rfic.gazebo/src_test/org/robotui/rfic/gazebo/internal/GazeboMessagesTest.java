package org.robotui.rfic.gazebo.internal;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertInstanceOf;
import static org.junit.jupiter.api.Assertions.assertTrue;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.Duration;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Queue;
import java.util.UUID;
import java.util.concurrent.ConcurrentLinkedQueue;
import java.util.concurrent.ThreadFactory;
import java.util.concurrent.locks.LockSupport;
import java.util.function.BooleanSupplier;
import java.util.stream.Stream;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.robotui.api.Rfic;
import org.robotui.api.port.Browser;
import org.robotui.api.port.CallException;
import org.robotui.api.port.CommandSink;
import org.robotui.api.port.CommandSink.Sent;
import org.robotui.data.command.MessageCommand;
import org.robotui.data.record.FieldPath;
import org.robotui.data.record.FieldValue;
import org.robotui.gazebo.GazeboNode;
import org.robotui.gazebo.GazeboOptions;
import org.robotui.gazebo.types.GazeboTypes;
import org.robotui.message.payload.protobuf.ProtobufFormat;
import org.robotui.testkit.FakeRficContext;

/** Single messages, as the topics view says them. */
class GazeboMessagesTest {
  private static final String TEXT = "ignition.msgs.StringMsg";
  private static final String TWIST = "ignition.msgs.Twist";
  private static final Path TOOL = Path.of("/usr/libexec/ignition/transport11/ign-transport-topic");
  private static final Duration PATIENCE = Duration.ofMinutes(3);
  private static final ThreadFactory DAEMONS = Thread.ofPlatform().daemon().factory();

  private final String partition = UUID.randomUUID().toString();
  private final FakeRficContext context = new FakeRficContext();
  private final Queue<String> heard = new ConcurrentLinkedQueue<>();
  private GazeboNode robot;
  private Rfic rfic;

  @BeforeEach
  void meet() throws IOException {
    robot = GazeboNode.open(GazeboOptions.of(Map.of("IGN_PARTITION", partition), DAEMONS), reason -> {});
    List.of("/note", "/silent").forEach(topic -> robot.advertise(topic, TEXT));
    robot.advertise("/model/rover/odometry", "ignition.msgs.Odometry");
    robot.advertise("/seen/twist", TWIST);
    rfic = GazeboCase.rfic(context, Map.of("partition", partition));
    rfic.start();
    await(() -> context.sinks.containsKey("publish") && lists("/note")
        && Stream.of("/note", "/silent", "/seen/twist", "/model/rover/cmd_vel")
            .allMatch(topic -> wrong(topic).contains(" carries ")));
  }

  @AfterEach
  void part() {
    rfic.close();
    robot.close();
  }

  private static void await(BooleanSupplier what) {
    long end = System.nanoTime() + PATIENCE.toNanos();
    while (!what.getAsBoolean()) {
      assertTrue(System.nanoTime() < end, "did not happen in time");
      LockSupport.parkNanos(Duration.ofMillis(50).toNanos());
    }
  }

  private boolean lists(String topic) {
    try {
      return context.browsers.containsKey("graph") && context.browsers.get("graph").list(Browser.Kind.TOPIC).stream()
          .anyMatch(item -> item.name().equals(topic));
    } catch (CallException e) {
      throw new AssertionError(e);
    }
  }

  @SuppressWarnings("unchecked") // the port takes such commands
  private Sent say(String topic, String type, Map<String, Object> fields) {
    return ((CommandSink<MessageCommand>) context.sinks.get("publish")).send(new MessageCommand(topic, type, fields));
  }

  private String refusal(String topic, String type, Map<String, Object> fields) {
    return assertInstanceOf(Sent.Refused.class, say(topic, type, fields)).reason();
  }

  /** Says nothing, as no topic has this type. */
  private String wrong(String topic) {
    return refusal(topic, "ignition.msgs.Odometry", Map.of());
  }

  private void listen() {
    ProtobufFormat format = new ProtobufFormat(GazeboTypes.of(Map.of()).find(TEXT).orElseThrow());
    robot.subscribe("/note", TEXT, 10, (sender, payload, nanos) -> heard
        .add(format.read(payload).at(FieldPath.parse("data")).map(v -> ((FieldValue.Text) v).value()).orElse("")));
  }

  @Test
  void aMessageIsSaidByTheNamesOfItsFields() {
    listen();
    assertInstanceOf(Sent.Out.class,
        say("/note", TEXT, Map.of("header", Map.of("stamp", Map.of("sec", 0, "nsec", 0)), "data", "hello")));
    await(() -> { // where it takes the listener long to connect, the first one is not heard
      say("/note", TEXT, Map.of("data", "hello again"));
      return heard.contains("hello again");
    });
    assertEquals(TEXT + " is not filled in like this: " + TEXT + " has no field 'text'",
        refusal("/note", TEXT, Map.of("text", "x")));
  }

  @Test
  void whatMovesTheRobotOrNobodyHearsIsRefused() {
    String moves = " moves the robot; drive it with a view that limits and ends the motion";
    assertEquals("/model/rover/cmd_vel" + moves, refusal("/model/rover/cmd_vel", TWIST, Map.of()));
    assertEquals("/seen/twist" + moves, refusal("/seen/twist", TWIST, Map.of()));
    assertEquals("/note carries " + TEXT + ", not " + TWIST, refusal("/note", TWIST, Map.of()));
    assertEquals("nobody subscribes to /nowhere", refusal("/nowhere", TEXT, Map.of()));
    assertInstanceOf(Sent.Out.class, say("/silent", TEXT, Map.of("data", "x")));
    await(() -> say("/silent", TEXT, Map.of("data", "x")) instanceof Sent.Refused refused
        && refused.reason().equals("nobody subscribes to /silent"));
  }

  /** The tool of the real transport. */
  @Test
  void theToolOfGazeboHearsIt(@TempDir Path folder) throws IOException {
    assumeTrue(Files.isExecutable(TOOL), "needs the Debian package ignition-transport-cli");
    Path out = folder.resolve("heard");
    ProcessBuilder builder =
        new ProcessBuilder(TOOL.toString(), "-e", "-t", "/note").redirectErrorStream(true).redirectOutput(out.toFile());
    builder.environment().putAll(Map.of("IGN_PARTITION", partition, "IGN_IP", "127.0.0.1"));
    Process tool = builder.start();
    try {
      await(() -> {
        say("/note", TEXT, Map.of("data", "hello, Gazebo"));
        return text(out).filter(all -> all.contains("data: \"hello, Gazebo\"")).isPresent();
      });
    } finally {
      tool.destroyForcibly();
    }
  }

  private static Optional<String> text(Path file) {
    try {
      return Files.exists(file) ? Optional.of(Files.readString(file)) : Optional.empty();
    } catch (IOException e) {
      throw new UncheckedIOException(e);
    }
  }
}
