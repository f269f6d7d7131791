package org.robotui.lcm;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.robotui.lcm.log.EventLogWriter;

/** Logs and memory as connections. */
class FileTest {

  private final TestThreads threads = new TestThreads();
  private final Heard heard = new Heard();

  @TempDir
  private Path folder;

  @AfterEach
  void stop() {
    threads.assertNoneLeft();
  }

  private Lcm open(String url) {
    return Lcm.open(LcmUrl.of(url), LcmOptions.standard(threads));
  }

  private Path log(long... utimes) throws IOException {
    Path path = folder.resolve("drive.lcmlog");
    try (EventLogWriter writer = EventLogWriter.create(path)) {
      for (long utime : utimes) {
        writer.write(utime, "POSE", Heard.text(Long.toString(utime)));
      }
    }
    return path;
  }

  /** Subscribes before the log is there, so that nothing is missed. */
  private Lcm play(Path log, String options) throws IOException {
    Path hidden = Files.move(log, folder.resolve("hidden"));
    Lcm lcm = open("file://" + log + options);
    lcm.subscribe(".*", SubscriptionOptions.direct(), heard);
    Files.move(hidden, log);
    return lcm;
  }

  private static void awaitEnd(Lcm lcm) {
    Eventually.await("the end of the log: " + lcm.state(), () -> lcm.state() instanceof LcmState.Ended);
  }

  @Test
  void aLogIsPlayedInItsOwnTimeOrFaster() throws IOException {
    Path log = log(0, 200_000, 400_000);
    try (Lcm lcm = play(log, "?speed=2")) {
      awaitEnd(lcm);
      List<LcmMessage> messages = heard.messages();
      assertEquals(List.of("POSE=0", "POSE=200000", "POSE=400000"), heard.texts());
      double seconds = (messages.getLast().received() - messages.getFirst().received()) * 1e-9;
      assertTrue(seconds >= 0.19 && seconds < 30, seconds + " s for 0.4 s at speed 2");
      assertEquals(400_000, messages.getLast().utime());
      assertEquals(log.toString(), messages.getLast().sender());
      assertThrows(IOException.class, () -> lcm.publish("POSE", Heard.text("")));
    }
  }

  @Test
  void aLogOfHoursIsPlayedAtOnceFromTheMiddle() throws IOException {
    try (Lcm lcm = play(log(0, 3_600_000_000L, 7_200_000_000L), "?speed=0&start_timestamp=3600000000")) {
      awaitEnd(lcm);
      assertEquals(List.of("POSE=3600000000", "POSE=7200000000"), heard.texts());
      assertTrue(lcm.state().toString().contains("drive.lcmlog is at its end"), lcm.state().toString());
    }
  }

  @Test
  void aWaitForTheNextEventEndsWithTheConnection() throws IOException {
    Lcm lcm = play(log(0, 3_600_000_000L), "");
    Eventually.await("the first event", () -> heard.texts().size() == 1);
    lcm.close();
    assertEquals(new LcmState.Closed(), lcm.state());
  }

  @Test
  void damageIsCountedAndTheRestIsPlayed() throws IOException {
    Path log = log(0, 1, 2);
    byte[] bytes = Files.readAllBytes(log);
    bytes[0] = 0;
    Files.write(log, bytes);
    try (Lcm lcm = play(log, "")) {
      awaitEnd(lcm);
      assertEquals(List.of("POSE=1", "POSE=2"), heard.texts());
      assertTrue(lcm.statistics().damaged() == 1 && lcm.statistics().lastDamage().contains("33 bytes of the log"),
          lcm.statistics().toString());
    }
  }

  @Test
  void whatIsPublishedIsWrittenAndReadAgain() throws IOException {
    Path path = folder.resolve("written.lcmlog");
    for (String mode : List.of("w", "a")) {
      try (Lcm lcm = open("file://" + path + "?mode=" + mode)) {
        Eventually.await("the file", () -> lcm.state() instanceof LcmState.Connected);
        lcm.publish("OUT", Heard.text(mode));
      }
    }
    try (Lcm lcm = play(path, "?speed=0")) {
      awaitEnd(lcm);
      assertEquals(List.of("OUT=w", "OUT=a"), heard.texts());
    }
  }

  @Test
  void memoryBringsMessagesInOrderAlsoThoseOfListeners() throws IOException {
    try (Lcm lcm = open("memq://")) {
      Eventually.await("memory", () -> lcm.state() instanceof LcmState.Connected);
      lcm.subscribe("ASK", SubscriptionOptions.direct(), message -> {
        try {
          lcm.publish("ANSWER", message.data());
        } catch (IOException e) {
          throw new IllegalStateException(e);
        }
      });
      lcm.subscribe("ANSWER", SubscriptionOptions.direct(), heard);
      ByteBuffer data = Heard.text("a");
      lcm.publish("ASK", data);
      data.put(0, (byte) 'x');
      lcm.publish("ASK", Heard.text("b"));
      Eventually.await("the answers", () -> heard.texts().equals(List.of("ANSWER=a", "ANSWER=b")));
    }
  }
}
