package org.robotui.ui.ask;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.util.List;
import java.util.Optional;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.robotui.api.port.SourceId;

class StreamNamesTest {
  @Test
  void portsOfTheWholeGraphAreTopicsWithoutTheirSlash() {
    StreamNames names = names(List.of("/odom", "/arm/odom", "/scan"), "odom", "arm/odom", "scan");
    assertEquals(stream("odom"), names.find("/odom"));
    assertEquals(stream("arm/odom"), names.find("/arm/odom"));
  }

  @Test
  void portsAreRelativeToTheNamespaceUnderWhichMostAreTopics() {
    StreamNames names = names(List.of("/odom", "/robot/odom", "/robot/scan", "/other/scan"), "odom", "scan");
    assertEquals(stream("odom"), names.find("/robot/odom"));
    assertEquals(stream("scan"), names.find("/robot/scan"));
    assertEquals(Optional.empty(), names.find("/odom"));
    assertEquals(Optional.empty(), names.find("/other/scan"));
  }

  @Test
  void whatIsNotOfferedHasNoStream() {
    assertEquals(Optional.empty(), names(List.of("/tf", "/odom"), "odom").find("/tf"));
    assertEquals(Optional.empty(), names(List.of("/tf")).find("/tf"));
  }

  @Test
  void aWrittenSlashDoesNotMatter() {
    assertEquals(stream("/odom"), names(List.of("/odom"), "/odom").find("/odom"));
  }

  private static StreamNames names(List<String> topics, String... ports) {
    return StreamNames.of(topics, Stream.of(ports).map(p -> new SourceId("base", p)).toList());
  }

  private static Optional<SourceId> stream(String port) {
    return Optional.of(new SourceId("base", port));
  }
}
