package org.robotui.recorder.internal.file;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertInstanceOf;
import static org.junit.jupiter.api.Assertions.assertTrue;
import static org.robotui.recorder.internal.file.RecordedRobot.await;
import static org.robotui.recorder.internal.file.RecordedRobot.texts;

import java.nio.file.Path;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalLong;
import java.util.stream.Collectors;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.robotui.api.port.Arity;
import org.robotui.api.port.Intake;
import org.robotui.api.port.StreamPort;
import org.robotui.api.record.RecordingChoice;
import org.robotui.api.record.RecordingOutcome;
import org.robotui.api.record.RecordingPacking;
import org.robotui.api.record.RecordingPlan;
import org.robotui.api.record.RecordingStatus;
import org.robotui.data.record.DynamicRecord;
import org.robotui.recording.RecordedChannel;
import org.robotui.recording.RecordingReader;
import org.robotui.testkit.host.FakeHost;

class RecordedChoiceTest {
  private final FakeHost host = new FakeHost();
  private final RecordedRobot robot = new RecordedRobot("Natalie", "scan", "odom", "joints");
  private final RecorderCore recorder = new RecorderCore(host, "1.2.3");
  private @TempDir Path folder;

  @AfterEach
  void end() {
    recorder.close();
  }

  private static List<Path> done(RecordingOutcome outcome) {
    return assertInstanceOf(RecordingOutcome.Done.class, outcome, outcome.sentence()).files();
  }

  private RecordingStatus status() {
    return recorder.state().recording().orElseThrow();
  }

  private void awaitMessages(String topic, long count) throws InterruptedException {
    await(() -> status().channels().stream().filter(each -> each.topic().equals(topic))
        .anyMatch(each -> each.messages() >= count));
  }

  @Test
  void sendersOfOneTopicStayApartAndEachOnesLastMessageHolds() throws Exception {
    host.add(robot.ruic);
    done(recorder.start(new RecordingPlan(folder.resolve("run.mcap"), RecordingChoice.ALL, RecordingPacking.NONE,
        OptionalLong.of(1 << 20), Optional.empty())));
    robot.says("odom", RecordedRobot.raw("/map", "/upstairs", true, "up"));
    robot.says("odom", RecordedRobot.raw("/map", "/downstairs", true, "down"));
    robot.says("odom", RecordedRobot.raw("/map", "/sketch", false, "passing"));
    awaitMessages("/map", 3); // ports are looked into one after the other
    for (int i = 0; i < 12; i++) {
      robot.says("scan", "/scan", false, "x".repeat(200_000));
    }
    awaitMessages("/scan", 12);
    assertEquals(1, status().channels().stream().filter(each -> each.topic().equals("/map")).count());
    Path second = done(recorder.stop()).get(1);

    try (RecordingReader recording = RecordedRobot.open(second)) {
      assertEquals(Map.of("/upstairs", "up", "/downstairs", "down"),
          RecordedRobot.messages(recording, "/map").stream().collect(Collectors
              .toMap(message -> message.channel().metadata().get("callerid"), RecordedRobot::text)));
      assertTrue(recording.channels().stream().filter(each -> each.topic().equals("/map"))
          .allMatch(RecordedChannel::isLatched));
    }
  }

  @Test
  void whatIsSentOnRequestAloneIsLeftOutUnlessItIsNamed() throws Exception {
    robot.ruic.ports().offer("base",
        new StreamPort<>("joints", DynamicRecord.class, Arity.MANY, "", Intake.CHOSEN));
    host.add(robot.ruic);
    Path file = folder.resolve("all.mcap");
    done(recorder.start(RecordingPlan.of(file)));
    await(() -> status().leftOut().equals(List.of("base.joints")));
    robot.says("joints", "/joints", false, "no");
    robot.says("scan", "/scan", false, "yes");
    awaitMessages("/scan", 1);
    recorder.stop();
    assertEquals(List.of(), texts(file, "/joints"));

    done(recorder.start(RecordingPlan.of(folder.resolve("named.mcap"))
        .choosing(new RecordingChoice(List.of(), List.of("*")))));
    await(() -> {
      robot.says("joints", "/joints", false, "yes");
      return status().channels().stream().anyMatch(each -> each.topic().equals("/joints"));
    });
    assertEquals(List.of(), status().leftOut());
  }
}
