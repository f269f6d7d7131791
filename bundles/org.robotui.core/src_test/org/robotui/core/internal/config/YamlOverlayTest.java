package org.robotui.core.internal.config;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.fail;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.stream.Collectors;
import java.util.stream.IntStream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import org.robotui.api.layout.Arrangement;
import org.robotui.api.layout.Arrangement.Added;
import org.robotui.api.layout.Arrangement.OwnWindow;
import org.robotui.api.layout.Layout;
import org.robotui.api.layout.WindowBounds;
import org.robotui.api.port.SourceId;
import org.robotui.core.internal.config.model.ChosenInterface;
import org.robotui.core.internal.config.model.KeptViews;
import org.robotui.core.internal.config.model.KeptViews.Hand;
import org.robotui.core.internal.config.model.Overlay;
import org.robotui.core.internal.config.model.PerspectiveFile;
import org.robotui.core.internal.config.model.PerspectiveFile.View;

class YamlOverlayTest {
  private static final Arrangement ARRANGED = new Arrangement(
      new Layout.Split(Layout.Direction.ROW,
          List.of(new Layout.Tabs(List.of("map", "scene3d"), 1),
              new Layout.Split(Layout.Direction.COLUMN, List.of(new Layout.View("camera"), new Layout.View("plot-2")),
                  List.of(0.25, 0.75))),
          List.of(2.0, 1.5)),
      List.of(new OwnWindow(new Layout.View("log"), new WindowBounds(-1920, 20, 640, 480))),
      List.of(new Added("plot-2", "plot")));
  private static final KeptViews VIEWS = new KeptViews(
      Optional.of(new Hand(ARRANGED, Set.of("map", "camera"), "3c")),
      Map.of("Drive", ARRANGED, "Inspect: arm", new Arrangement(new Layout.Tabs(List.of()))), Optional.of("Drive"));

  @TempDir
  Path folder;

  private static Map<String, Overlay> read(Path file) throws IOException {
    return new YamlOverlay().read(file, damage -> fail(damage));
  }

  /** A hand that slipped in one robot loses nothing of the others. */
  @ParameterizedTest
  @ValueSource(strings = {"views: {arrangement: 5}", "views: {arrangement: {layout: {row: [a]}}}", "settings: [1]",
      "rfics: {base: 5}"})
  void whatIsDamagedIsLeftOutAlone(String damaged) throws IOException {
    Path file = Files.writeString(folder.resolve("odd.yaml"), "a: {" + damaged + "}\nb: {settings: {map: {zoom: 2}}}");
    List<String> told = new ArrayList<>();
    Map<String, Overlay> kept = new YamlOverlay().read(file, told::add);
    assertEquals(List.of("b"), List.copyOf(kept.keySet()));
    assertEquals(Map.of("zoom", 2L), kept.get("b").settings().get("map"));
    assertEquals(1, told.size());
  }

  @Test
  void readsWhatItWrote() throws IOException {
    Map<String, Overlay> kept = Map.of("Natalie", new Overlay(
        Map.of("map", Map.of("follow", true, "radius", 0.25, "trail", 5000L, "layers", List.of("scan", "map"))),
        Map.of(new SourceId("camera", "image"), new SourceId("base", "camera/image_raw")),
        Map.of("base", new ChosenInterface("player", "Natalie", Map.of("port", "6665", "quick", true), "1f")), VIEWS));
    Path file = folder.resolve("new folder").resolve("overlay.yaml");
    new YamlOverlay().write(file, kept);
    assertEquals(kept, read(file));
  }

  /** YAML would name a list that comes again, and a reader has few names. */
  @Test
  void readsAsManyPerspectivesAsOneLikes() throws IOException {
    Map<String, Arrangement> many =
        IntStream.range(0, 200).boxed().collect(Collectors.toMap(i -> "number " + i, i -> ARRANGED));
    Map<String, Overlay> kept = Map.of("Natalie",
        new Overlay(Map.of(), Map.of(), Map.of(), new KeptViews(Optional.empty(), many, Optional.empty())));
    Path file = folder.resolve("overlay.yaml");
    new YamlOverlay().write(file, kept);
    assertEquals(kept, read(file));
    assertFalse(Files.readString(file).contains("&"));
  }

  @Test
  void aPerspectiveForOthersIsReadAsItWasWritten() throws IOException {
    PerspectiveFile file = new PerspectiveFile("Drive",
        new Arrangement(ARRANGED.layout(), ARRANGED.windows(), List.of()),
        Map.of("map", new View("map", Map.of("follow", true, "trail", 5000L)), "plot-2", new View("plot", Map.of())));
    assertEquals(file, new YamlOverlay().perspective(new YamlOverlay().text(file)));
  }

  @ParameterizedTest
  @ValueSource(strings = {"", "[1]", "a: b", "robotui_perspective: 9", "robotui_perspective: 1\nlayout: 5",
      "robotui_perspective: 1\nlayout: {row: [{view: a}]}", "robotui_perspective: 1\nlayout: {tabs: [a, a]}",
      "robotui_perspective: 1\nlayout: {view: a}\nwindows: [{at: [1, 2, 3, 4], layout: {view: a}}]",
      "robotui_perspective: 1\nlayout: {view: a}\nwindows: [{at: [1, 2, 0, 4], layout: {view: b}}]",
      "robotui_perspective: 1\nlayout: {view: a}\nwindows: [{at: [1, x], layout: {view: b}}]"})
  void refusesWhatIsNoPerspective(String text) {
    assertFalse(assertThrows(IOException.class, () -> new YamlOverlay().perspective(text)).getMessage().isBlank());
  }

  @Test
  void answersNothingWithoutAFile() throws IOException {
    assertEquals(Map.of(), read(folder.resolve("none.yaml")));
  }

  @Test
  void refusesWhatItDidNotWrite() throws IOException {
    Path file = Files.writeString(folder.resolve("odd.yaml"), "[1, 2]");
    assertThrows(IOException.class, () -> read(file));
  }

  @ParameterizedTest
  @ValueSource(strings = {"a: &a {settings: {map: {x: *a}}}", "a: {settings: {map: &l [*l]}}",
      "a: {settings: {map: {x: &l [*l]}}}",
      "!!java.lang.Object {}", "a: [", "\0"})
  void refusesWhatWouldNeverEndOrIsNothing(String text) throws IOException {
    Path file = Files.writeString(folder.resolve("odd.yaml"), text);
    assertThrows(IOException.class, () -> read(file));
  }

  @Test
  void whatIsEmptyCountsAsNothing() throws IOException {
    Path file = Files.writeString(folder.resolve("empty.yaml"), "a: {settings: {map: , ~: {x: ~}}}\nb:");
    assertEquals(List.of("a", "b"), List.copyOf(read(file).keySet()));
  }
}
