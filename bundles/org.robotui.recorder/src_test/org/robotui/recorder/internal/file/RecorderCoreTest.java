package org.robotui.recorder.internal.file;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertInstanceOf;
import static org.junit.jupiter.api.Assertions.assertTrue;
import static org.robotui.recorder.internal.file.RecordedRobot.await;
import static org.robotui.recorder.internal.file.RecordedRobot.id;
import static org.robotui.recorder.internal.file.RecordedRobot.texts;

import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.Duration;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalLong;
import java.util.Set;
import java.util.concurrent.atomic.AtomicInteger;
import java.util.stream.Collectors;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.robotui.api.port.RawMessage;
import org.robotui.api.record.RecorderState.Ended;
import org.robotui.api.record.RecordingChoice;
import org.robotui.api.record.RecordingOutcome;
import org.robotui.api.record.RecordingPacking;
import org.robotui.api.record.RecordingPlan;
import org.robotui.api.record.RecordingStatus;
import org.robotui.recording.RecordedAttachment;
import org.robotui.recording.RecordedChannel;
import org.robotui.recording.RecordedMessage;
import org.robotui.recording.RecordedMetadata;
import org.robotui.recording.RecordedSchema;
import org.robotui.recording.RecordingException;
import org.robotui.recording.RecordingReader;
import org.robotui.recording.RecordingWriter;
import org.robotui.recording.Recordings;
import org.robotui.recording.ScanProgress;
import org.robotui.testkit.FakeAuthority;
import org.robotui.testkit.host.FakeHost;

class RecorderCoreTest {
  private final FakeHost host = new FakeHost();
  private final RecordedRobot robot = new RecordedRobot("Natalie", "scan", "odom", "joints");
  private final RecorderCore recorder = new RecorderCore(host, "1.2.3");
  private @TempDir Path folder;

  @AfterEach
  void end() {
    recorder.close();
  }

  private Path begin() {
    host.add(robot.ruic);
    Path file = folder.resolve("run.mcap");
    done(recorder.start(RecordingPlan.of(file)));
    return file;
  }

  private static List<Path> done(RecordingOutcome outcome) {
    return assertInstanceOf(RecordingOutcome.Done.class, outcome, outcome.sentence()).files();
  }

  private RecordingStatus status() {
    return recorder.state().recording().orElseThrow();
  }

  private void awaitMessages(String topic, long count) throws InterruptedException {
    await(() -> status().channels().stream().filter(each -> each.topic().equals(topic))
        .mapToLong(RecordingStatus.Channel::messages).sum() >= count);
  }

  @Test
  void messagesAreInTheFileAsTheyCame() throws Exception {
    Path file = begin();
    robot.says("scan", "/scan", false, "first");
    robot.says("scan", "/scan", false, "second");
    awaitMessages("/scan", 2);
    done(recorder.stop());

    try (RecordingReader recording = RecordedRobot.open(file)) {
      List<RecordedMessage> messages = RecordedRobot.messages(recording, "/scan");
      assertEquals(List.of("first", "second"), messages.stream().map(RecordedRobot::text).toList());
      RecordedChannel channel = messages.getFirst().channel();
      assertEquals("cdr", channel.messageEncoding());
      assertEquals(new RecordedSchema("std_msgs/msg/String", "ros2msg", "string data\n".getBytes(
          StandardCharsets.UTF_8)), channel.schema());
      assertEquals(Map.of("robotui.ui", "Natalie", "robotui.robot", "Natalie", "robotui.framework", "ros2",
          "robotui.interface", "base", "robotui.port", "scan", "robotui.type", "std_msgs/String", "callerid", "/node"),
          channel.metadata());
      assertEquals(RecordedRobot.STAMP, messages.getFirst().publishTime());
      assertTrue(Math.abs(messages.getFirst().logTime() / 1e6 - System.currentTimeMillis()) < 60_000);
      assertTrue(recording.isIndexed());
    }
  }

  @Test
  void aMessageThatSeveralPortsGiveIsThereOnce() throws Exception {
    Path file = begin();
    RawMessage raw = RecordedRobot.raw("pose", false, "one");
    robot.says("scan", raw);
    robot.says("odom", raw);
    robot.says("odom", "pose", false, "one");
    awaitMessages("pose", 2);
    recorder.stop();

    assertEquals(List.of("one", "one"), texts(file, "pose"));
  }

  @Test
  void dataWithoutAMessageAreJsonWithASchema() throws Exception {
    Path file = begin();
    robot.ruic.ports().put(id("joints"), RecordedRobot.value("bent"));
    awaitMessages("/Natalie/base.joints", 1);
    recorder.stop();

    try (RecordingReader recording = RecordedRobot.open(file)) {
      RecordedMessage message = RecordedRobot.messages(recording, "/Natalie/base.joints").getFirst();
      assertEquals("{\"data\":\"bent\"}", RecordedRobot.text(message));
      assertEquals("json", message.channel().messageEncoding());
      assertEquals("jsonschema", message.channel().schema().encoding());
      String schema = new String(message.channel().schema().definition(), StandardCharsets.UTF_8);
      assertTrue(schema.contains("\"properties\":{\"data\":{\"type\":\"string\"}}"), schema);
    }
  }

  @Test
  void onlyWhatIsChosenIsAskedFor() throws Exception {
    RecordedRobot other = new RecordedRobot("Keira", "scan");
    host.add(other.ruic).add(robot.ruic);
    Path file = folder.resolve("chosen.mcap");
    done(recorder.start(RecordingPlan.of(file)
        .choosing(new RecordingChoice(List.of("Nat*"), List.of("{scan,base.o*}")))));
    other.says("scan", "/keira/scan", false, "no");
    robot.says("joints", "/joints", false, "no");
    robot.says("scan", "/scan", false, "yes");
    robot.says("odom", "/odom", false, "yes");
    awaitMessages("/scan", 1);
    awaitMessages("/odom", 1);
    recorder.stop();

    assertEquals(List.of(), texts(file, "/keira/scan"));
    assertEquals(List.of(), texts(file, "/joints"));
  }

  @Test
  void whatHeldBeforeIsInItAndWhatPassedIsNot() throws Exception {
    robot.says("odom", "/map", true, "map");
    robot.says("scan", "/scan", false, "old");
    robot.ruic.ports().hold(id("joints"), List.of(RecordedRobot.raw("/tf_static", true, "fixed")));
    Path file = begin();
    robot.says("scan", "/scan", false, "new");
    awaitMessages("/scan", 1);
    awaitMessages("/map", 1);
    awaitMessages("/tf_static", 1);
    recorder.stop();

    assertEquals(List.of("map"), texts(file, "/map"));
    assertEquals(List.of("new"), texts(file, "/scan"));
    assertEquals(List.of("fixed"), texts(file, "/tf_static"));
    try (RecordingReader recording = Recordings.open(file, ScanProgress.NONE)) {
      assertEquals(Set.of("/map", "/tf_static"), recording.channels().stream().filter(RecordedChannel::isLatched)
          .map(RecordedChannel::topic).collect(Collectors.toSet()));
    }
  }

  @Test
  void eachOfSeveralFilesBeginsWithWhatHolds() throws Exception {
    host.add(robot.ruic);
    done(recorder.start(new RecordingPlan(folder.resolve("run.mcap"), RecordingChoice.ALL, RecordingPacking.NONE,
        OptionalLong.of(1 << 20), Optional.empty())));
    robot.says("odom", "/map", true, "map");
    awaitMessages("/map", 1);
    String large = "x".repeat(200_000);
    for (int i = 0; i < 20; i++) {
      robot.says("scan", "/scan", false, large);
    }
    awaitMessages("/scan", 20);
    List<Path> files = done(recorder.stop());

    assertTrue(files.size() >= 3, files.toString());
    assertEquals(List.of("run_0001.mcap", "run_0002.mcap"),
        files.subList(0, 2).stream().map(each -> each.getFileName().toString()).toList());
    int scans = 0;
    for (Path each : files) {
      assertEquals(List.of("map"), texts(each, "/map"), each.toString());
      scans += texts(each, "/scan").size();
    }
    assertEquals(20, scans);
  }

  @Test
  void whatIsLostIsCountedAndToldInTheFile() throws Exception {
    Path file = begin();
    robot.says("scan", "/scan", false, "first");
    robot.ruic.ports().drop(id("scan"), 7);
    robot.says("scan", "/scan", false, "second");
    awaitMessages("/scan", 2);
    await(() -> status().problems().stream().anyMatch(each -> each.startsWith("7 messages could not be taken")));
    recorder.stop();

    try (RecordingReader recording = RecordedRobot.open(file)) {
      RecordedMetadata drops =
          recording.metadata().stream().filter(each -> each.name().equals("robotui.drops")).findFirst().orElseThrow();
      assertEquals(Map.of("/scan", "7"), drops.values());
    }
  }

  @Test
  void eventsSayWhoDrivesAndStops() throws Exception {
    Path file = begin();
    robot.ruic.authority().take(FakeAuthority.YOU, false);
    awaitMessages("/robotui/events", 4); // state, interface, control and stop as they are
    robot.ruic.authority().stop(FakeAuthority.ANNA);
    recorder.stop();

    List<String> events = texts(file, "/robotui/events");
    assertTrue(events.contains(
        "{\"event\":\"control\",\"ui\":\"Natalie\",\"subject\":\"Natalie\",\"value\":\"You\",\"text\":\"\"}"),
        events.toString());
    assertTrue(events.contains(
        "{\"event\":\"stop\",\"ui\":\"Natalie\",\"subject\":\"Natalie\",\"value\":\"Anna\",\"text\":\"\"}"),
        events.toString());
  }

  @Test
  void configurationAndVersionsLieBesideTheMessages() throws Exception {
    host.configured(Map.of(Path.of("demo.yaml"), "password: ***\n"));
    Path file = begin();
    recorder.stop();

    try (RecordingReader recording = RecordedRobot.open(file)) {
      RecordedAttachment attachment = recording.attachments().getFirst();
      assertEquals("demo.yaml", attachment.name());
      assertEquals("password: ***\n", StandardCharsets.UTF_8.decode(recording.content(attachment)).toString());
      assertEquals("1.2.3", recording.metadata().getFirst().values().get("robotui"));
    }
  }

  @Test
  void aPlaceThatCannotBeWrittenIsToldBefore() throws Exception {
    Path there = Files.createFile(folder.resolve("there.mcap"));
    Path missing = folder.resolve("no/such.mcap");

    assertEquals(Optional.of(there + " is there already, and is not written over; choose another name"),
        recorder.obstacle(RecordingPlan.of(there)));
    assertEquals(
        Optional.of("the folder " + missing.getParent() + " is not there; make it, or choose another one"),
        recorder.obstacle(RecordingPlan.of(missing)));
    assertInstanceOf(RecordingOutcome.Refused.class, recorder.start(RecordingPlan.of(missing)));
    assertEquals(Optional.empty(), recorder.obstacle(RecordingPlan.of(folder)));
  }

  @Test
  void aDiskWithoutRoomIsToldBefore() {
    RecorderCore full = new RecorderCore(host, "1", diskWith(50 << 20), RecordingWriter::create);

    String sentence = full.obstacle(RecordingPlan.of(folder)).orElseThrow();

    assertTrue(sentence.startsWith("only 50 MB are left where " + folder), sentence);
  }

  private static Disk diskWith(long bytes) {
    return new Disk() {
      @Override
      protected long left(Path of) throws IOException {
        return bytes;
      }
    };
  }

  @Test
  void aDiskThatFillsUpEndsTheRecordingWhileItCanStillBeWhole() throws Exception {
    AtomicInteger looks = new AtomicInteger();
    Disk filling = new Disk() {
      @Override
      protected long left(Path of) {
        return looks.incrementAndGet() < 3 ? 1L << 40 : 1 << 20;
      }
    };
    RecorderCore short_ = new RecorderCore(host.add(robot.ruic), "1", filling, RecordingWriter::create);
    Path file = folder.resolve("run.mcap");
    done(short_.start(RecordingPlan.of(file)));
    robot.says("scan", "/scan", false, "kept");
    await(() -> short_.state().ended().isPresent());

    Ended ended = short_.state().ended().orElseThrow();
    assertTrue(ended.reason().contains("the disk is nearly full"), ended.reason());
    assertEquals(Optional.empty(), short_.state().recording());
    try (RecordingReader recording = RecordedRobot.open(file)) {
      assertTrue(recording.isIndexed());
    }
    assertInstanceOf(RecordingOutcome.Refused.class, short_.stop());
  }

  @Test
  void aDiskThatFailsEndsTheRecordingWithItsReason() throws Exception {
    RecorderCore failing = new RecorderCore(host.add(robot.ruic), "1", new Disk(),
        (file, options) -> new FailingWriter(RecordingWriter.create(file, options), file));
    done(failing.start(RecordingPlan.of(folder.resolve("run.mcap"))));
    robot.says("scan", "/scan", false, "lost");
    await(() -> failing.state().ended().isPresent());

    String reason = failing.state().ended().orElseThrow().reason();
    assertTrue(reason.contains("No space left on device"), reason);
    done(failing.start(RecordingPlan.of(folder.resolve("again.mcap"))));
    failing.close();
  }

  /** Takes the notes at the beginning, and no message. */
  private record FailingWriter(RecordingWriter writer, Path file) implements RecordingWriter {
    @Override
    public RecordedChannel channel(String topic, String encoding, RecordedSchema schema, Map<String, String> metadata) {
      return writer.channel(topic, encoding, schema, metadata);
    }

    @Override
    public void write(RecordedChannel channel, long logTime, long publishTime, long sequence, ByteBuffer data)
        throws RecordingException {
      throw new RecordingException(file, "cannot be written", new IOException("No space left on device"));
    }

    @Override
    public void attach(String name, String type, long logTime, long createTime, ByteBuffer content)
        throws RecordingException {
      writer.attach(name, type, logTime, createTime, content);
    }

    @Override
    public void note(RecordedMetadata metadata) throws RecordingException {
      writer.note(metadata);
    }

    @Override
    public void flush() throws RecordingException {
      writer.flush();
    }

    @Override
    public long size() {
      return writer.size();
    }

    @Override
    public void close() throws RecordingException {
      writer.close();
    }
  }

  @Test
  void theLastSecondsAreSavedWithWhatHeldBefore() throws Exception {
    host.add(robot.ruic);
    done(recorder.keepRecent(Duration.ofSeconds(1), RecordingChoice.ALL));
    robot.says("odom", "/map", true, "map");
    robot.says("scan", "/scan", false, "old");
    await(() -> recorder.state().recent().orElseThrow().messages() >= 6);
    Thread.sleep(1100); // what is older than the limit goes when something newer comes
    robot.says("scan", "/scan", false, "new");
    await(() -> recorder.state().recent().orElseThrow().messages() == 1);

    Path file = done(recorder.saveRecent(folder)).getFirst();

    assertEquals(List.of("new"), texts(file, "/scan"));
    assertEquals(List.of("map"), texts(file, "/map"));
    assertTrue(file.getFileName().toString().matches("recent_.*\\.mcap"), file.toString());
    recorder.forgetRecent();
    assertInstanceOf(RecordingOutcome.Refused.class, recorder.saveRecent(folder.resolve("other.mcap")));
  }

  @Test
  void thereIsOneRecordingAtATime() {
    begin();

    RecordingOutcome second = recorder.start(RecordingPlan.of(folder.resolve("second.mcap")));

    assertTrue(second.sentence().startsWith("it records already, to "), second.sentence());
    done(recorder.stop());
    assertEquals("nothing is recorded", recorder.stop().sentence());
  }

  @Test
  void listenersHearOfBeginAndEnd() throws Exception {
    AtomicInteger told = new AtomicInteger();
    recorder.listen(told::incrementAndGet);
    begin();
    int begun = told.get();
    recorder.stop();

    assertTrue(begun >= 1 && told.get() > begun);
  }
}
