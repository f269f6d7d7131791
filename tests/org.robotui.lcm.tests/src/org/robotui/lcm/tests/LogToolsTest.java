package org.robotui.lcm.tests;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.file.Path;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.robotui.lcm.log.EventLogIndex;
import org.robotui.lcm.log.EventLogWriter;

/** Logs of {@code lcm-logger} are read, and ours played by {@code lcm-logplayer}. */
class LogToolsTest {

  private LcmWorld world;

  @BeforeEach
  void start() throws Exception {
    LcmInstallation.assumeThere();
    world = new LcmWorld();
    world.ownNetwork();
  }

  @AfterEach
  void stop() throws Exception {
    if (world != null) {
      world.close();
    }
  }

  @Test
  void aLogOfTheStockLoggerIsRead() throws Exception {
    Path log = world.folder().resolve("stock.lcmlog");
    Peer logger =
        world.start("lcm-logger", "--lcm-url=" + LcmWorld.GROUP, log.toString()).awaitLine("Opening log file");
    Peer sender = world.ours(LcmWorld.GROUP, "send", "DATA_1", "1000", "500", "1000");
    sender.tell("go");
    sender.awaitLine("sent 500");
    Eventually.await("the log: " + logger.output(), () -> ends(log) > 20);
    logger.interrupt();
    logger.finish();
    EventLogIndex index = EventLogIndex.of(log);
    assertEquals(500, index.channels().get("DATA_1"));
    assertEquals(0, index.damagedBytes());
  }

  /** The logger writes now and then. */
  private static int ends(Path log) {
    try {
      return EventLogIndex.of(log).channels().getOrDefault("END", 0);
    } catch (IOException e) {
      return 0;
    }
  }

  @Test
  void aLogOfOursIsPlayedByTheStockPlayer() throws Exception {
    Path log = world.folder().resolve("ours.lcmlog");
    try (EventLogWriter writer = EventLogWriter.create(log)) {
      for (int i = 0; i < 200; i++) {
        byte[] data = new byte[2000];
        for (int at = 0; at < data.length; at++) {
          data[at] = (byte) (at * 31 + i);
        }
        writer.write(1_700_000_000_000_000L + i * 1000L, "DATA_LOG", ByteBuffer.wrap(data));
      }
      for (int i = 0; i < 20; i++) {
        writer.write(1_700_000_001_000_000L + i * 50_000L, "END", ByteBuffer.allocate(4));
      }
    }
    Peer receiver = world.ours(LcmWorld.GROUP, "receive", "DATA_.*");
    world.start("lcm-logplayer", "--lcm-url=" + LcmWorld.GROUP, log.toString());
    receiver.awaitLine("received 200 bad 0 missing 0");
  }
}
