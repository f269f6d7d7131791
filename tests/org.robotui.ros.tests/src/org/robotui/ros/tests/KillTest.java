package org.robotui.ros.tests;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.File;
import java.net.URISyntaxException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.Duration;
import java.util.List;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.robotui.message.RecordCodec;
import org.robotui.net.call.Outcome;
import org.robotui.ros.RosNode;
import org.robotui.ros.StaleRegistrations;
import org.slf4j.LoggerFactory;

/** What the real master has of one of our processes after a kill, and after the next one cleared up. */
class KillTest {

  private static final Duration TIME = Duration.ofSeconds(10);

  private RosWorld world;
  private Path records;
  private Peer talker;

  @BeforeEach
  void start() throws Exception {
    RosInstallation.assumeThere();
    world = new RosWorld();
    world.roscore();
    records = world.folder().resolve("records");
    talker = world.python("talker.py", "pythonist", "/chatter");
  }

  @AfterEach
  void stop() throws Exception {
    if (world != null) {
      world.close();
    }
  }

  private Peer doomed() throws Exception {
    String classPath = Stream.of(DoomedNode.class, RosNode.class, RecordCodec.class, Outcome.class, LoggerFactory.class)
        .flatMap(KillTest::places)
        .map(Path::toString).distinct().collect(Collectors.joining(File.pathSeparator));
    return world.start(Path.of(System.getProperty("java.home"), "bin", "java").toString(), "-cp", classPath,
        DoomedNode.class.getName(), world.masterUri().toString(), records.toString()).awaitLine("ready");
  }

  /** Where a class comes from: a jar, a folder of classes, or in a framework a bundle's project folder. */
  private static Stream<Path> places(Class<?> type) {
    try {
      Path place = Path.of(type.getProtectionDomain().getCodeSource().getLocation().toURI());
      return Stream.of(place, place.resolve("target/classes"), place.resolve("bin")).filter(Files::exists);
    } catch (URISyntaxException e) {
      throw new IllegalStateException(e);
    }
  }

  @Test
  void theNextProcessRemovesWhatAKillLeft() throws Exception {
    Peer doomed = doomed();
    doomed.kill();
    assertTrue(world.tool("rosnode", "list").contains("/doomed"));
    assertTrue(world.tool("rostopic", "info", "/chatter").contains("* /doomed"));
    assertEquals(List.of("/doomed"), StaleRegistrations.clear(records, TIME).nodes());
    assertFalse(world.tool("rosnode", "list").contains("/doomed"));
    assertFalse(world.tool("rosservice", "list").contains("/doomed"));
    String chatter = world.tool("rostopic", "info", "/chatter");
    assertTrue(chatter.contains("* /pythonist") && !chatter.contains("doomed") && chatter.contains("Subscribers: None"),
        chatter);
    assertEquals(List.of(), talker.lines().stream().filter(line -> line.contains("Traceback")).toList());
  }

  @Test
  void aProcessThatRunsIsLeftAlone() throws Exception {
    Peer running = doomed();
    assertEquals(List.of(), StaleRegistrations.clear(records, TIME).nodes());
    assertTrue(world.tool("rosnode", "ping", "-c", "1", "/doomed").contains("xmlrpc reply"));
    assertTrue(world.tool("rostopic", "info", "/chatter").contains("* /doomed"));
    running.kill();
  }
}
