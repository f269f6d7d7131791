package org.robotui.core.internal.config;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Map;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import org.robotui.api.port.SourceId;
import org.robotui.core.internal.config.model.ChosenInterface;
import org.robotui.core.internal.config.model.Overlay;

class YamlOverlayTest {
  @TempDir
  Path folder;

  @Test
  void readsWhatItWrote() throws IOException {
    Map<String, Overlay> kept = Map.of("Natalie", new Overlay(
        Map.of("map", Map.of("follow", true, "radius", 0.25, "trail", 5000L, "layers", List.of("scan", "map"))),
        Map.of(new SourceId("camera", "image"), new SourceId("base", "camera/image_raw")),
        Map.of("base", new ChosenInterface("player", "Natalie", Map.of("port", "6665", "quick", true), "1f"))));
    Path file = folder.resolve("new folder").resolve("overlay.yaml");
    new YamlOverlay().write(file, kept);
    assertEquals(kept, new YamlOverlay().read(file));
  }

  @Test
  void answersNothingWithoutAFile() throws IOException {
    assertEquals(Map.of(), new YamlOverlay().read(folder.resolve("none.yaml")));
  }

  @Test
  void refusesWhatItDidNotWrite() throws IOException {
    Path file = Files.writeString(folder.resolve("odd.yaml"), "[1, 2]");
    assertThrows(IOException.class, () -> new YamlOverlay().read(file));
  }

  @ParameterizedTest
  @ValueSource(strings = {"a: &a {settings: {map: {x: *a}}}", "a: {settings: {map: &l [*l]}}",
      "a: {settings: {map: {x: &l [*l]}}}",
      "!!java.lang.Object {}", "a: [", "\0"})
  void refusesWhatWouldNeverEndOrIsNothing(String text) throws IOException {
    Path file = Files.writeString(folder.resolve("odd.yaml"), text);
    assertThrows(IOException.class, () -> new YamlOverlay().read(file));
  }

  @Test
  void whatIsEmptyCountsAsNothing() throws IOException {
    Path file = Files.writeString(folder.resolve("empty.yaml"), "a: {settings: {map: , ~: {x: ~}}}\nb:");
    assertEquals(List.of("a", "b"), List.copyOf(new YamlOverlay().read(file).keySet()));
  }
}
