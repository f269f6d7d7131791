package org.robotui.core.internal.host;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertInstanceOf;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import java.util.stream.Stream;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.robotui.api.UicType.Surface;
import org.robotui.api.host.Arranging;
import org.robotui.api.host.Arranging.PerspectiveImport;
import org.robotui.api.host.Arranging.ViewChoice;
import org.robotui.api.host.RuicState;
import org.robotui.api.host.ViewFit;
import org.robotui.api.layout.Arrangement;
import org.robotui.api.layout.Arrangement.Added;
import org.robotui.api.layout.DropTarget;
import org.robotui.api.layout.Edge;
import org.robotui.api.layout.Layout;
import org.robotui.api.layout.WindowBounds;
import org.robotui.api.link.LinkState;
import org.robotui.api.port.Demand;
import org.robotui.core.internal.support.Await;
import org.robotui.core.internal.support.CoreBench;
import org.robotui.core.internal.support.FakeRobot;
import org.robotui.core.internal.support.FakeView;
import org.robotui.core.internal.support.Samples;

class ArrangingTest {
  private static final String HEAD = """
      ruics:
        pioneer:
          rfics:
            base: {type: fake}
          uics:
            map: {type: map, zoom: 3}
            camera: {type: camera}
            bell: {type: bell}
      """;
  private static final String YAML = HEAD + """
          layout: {row: [map, camera]}
          perspectives:
            Look: camera
      """;

  @TempDir
  Path folder;

  private CoreBench bench;
  private FakeView map;
  private FakeView camera;
  private FakeView bell;

  @BeforeEach
  void start() {
    bench = open(YAML);
  }

  private CoreBench open(String yaml) {
    CoreBench opened = new CoreBench(folder);
    opened.registry.add(new FakeRobot("fake").onStart(c -> {
      c.offers().stream(Samples.SCAN, Demand.IGNORED);
      c.link().report(new LinkState.Connected("robot"));
    }), "org.robotui.rfic.fake");
    map = new FakeView("map", Samples.SCAN);
    camera = new FakeView("camera");
    bell = new FakeView("bell").on(Surface.NONE);
    List.of(map, camera, bell).forEach(v -> opened.registry.add(v, "org.robotui.uic." + v.id()));
    assertEquals(List.of(), opened.load(yaml));
    opened.ruic();
    return opened;
  }

  @AfterEach
  void end() {
    bench.close();
  }

  private Arranging arranging() {
    return bench.ruic().arranging();
  }

  private void restart(String yaml) {
    bench.close();
    bench = open(yaml);
  }

  @Test
  void aClosedViewEndsAndTheOthersGoOn() {
    bench.await("map", RuicState.INITIALIZED);
    arranging().arrange(arranging().now().without("map"));
    Await.until("the map has ended", () -> map.closed.get() == 1);
    Await.until("it is not there any more",
        () -> bench.ruic().snapshot().components().stream().noneMatch(c -> c.id().equals("map")));
    assertEquals(List.of(0, 1, 1), List.of(camera.closed.get(), camera.contexts.size(), bell.contexts.size()));
    assertEquals(List.of(new ViewChoice("map", "map", "Fake view", false),
        new ViewChoice("camera", "camera", "Fake view", true)),
        arranging().views());
    arranging().arrange(arranging().now().with("map", new DropTarget.Side("camera", Edge.LEFT)));
    Await.until("it runs again", () -> map.contexts.size() == 2);
    bench.await("map", RuicState.INITIALIZED);
  }

  @Test
  void asManyViewsOfATypeAsOneLikes() {
    String id = arranging().freshId("map");
    assertEquals("map-2", id);
    arranging().arrange(arranging().now().adding(new Added(id, "map")).with(id, new DropTarget.Tab("map", 1)));
    bench.await(id, RuicState.INITIALIZED);
    Await.until("it is connected as the first is",
        () -> bench.match("map-2.scan").filter(m -> m.peers().size() == 1).isPresent());
    assertEquals("Fake view 2", bench.ruic().title(id));
    assertEquals("map-3", arranging().freshId("map"));
  }

  @Test
  void whatIsArrangedOutlivesARestart() {
    arranging().arrange(arranging().now().adding(new Added("map-2", "map"))
        .with("map-2", new DropTarget.OwnWindow(new WindowBounds(5, 6, 700, 800))).without("camera"));
    Arrangement before = arranging().now();
    restart(YAML);
    assertEquals(before, arranging().now());
    bench.await("map-2", RuicState.INITIALIZED);
    assertEquals(0, camera.contexts.size());
    arranging().reset();
    assertEquals(arranging().written(), arranging().now());
    Await.until("the camera runs", () -> camera.contexts.size() == 1);
    restart(YAML);
    assertEquals(arranging().written(), arranging().now());
  }

  @Test
  void aLayoutThatIsWrittenAnewHoldsAgain() {
    arranging().arrange(arranging().now().without("camera"));
    restart(YAML.replace("row:", "column:"));
    assertEquals(List.of("map", "camera"), arranging().now().views());
    Await.until("the user is told", () -> bench.alerts.stream().anyMatch(a -> a.contains("layout of pioneer")));
  }

  /** A new version of a type brings a view that the user has never seen. */
  @Test
  void aViewThatCameLaterLiesBesideItsNeighbours() {
    String without = HEAD.replace("      camera: {type: camera}\n", "");
    restart(without);
    arranging().arrange(arranging().now().with("map", new DropTarget.Border(0, Edge.LEFT)));
    arranging()
        .arrange(arranging().now().adding(new Added("map-2", "map")).with("map-2", new DropTarget.Tab("map", 9)));
    restart(HEAD);
    assertTrue(arranging().now().views().containsAll(List.of("map", "map-2", "camera")), arranging().now().toString());
  }

  @Test
  void perspectivesAreKeptChosenAndForgotten() {
    assertEquals(Set.of("Look"), arranging().perspectives().keySet());
    Arrangement usual = arranging().now();
    arranging().keep("Usual");
    assertThrows(IllegalArgumentException.class, () -> arranging().keep(" "));
    arranging().choose("Look");
    assertEquals(new Layout.View("camera"), arranging().now().layout());
    Await.until("the map has ended", () -> map.closed.get() == 1);
    restart(YAML);
    assertEquals(Optional.of("Look"), arranging().perspective());
    arranging().choose("Usual");
    assertEquals(usual, arranging().now());
    arranging().forget("Usual");
    arranging().forget("Look");
    assertEquals(Set.of("Look"), arranging().perspectives().keySet());
  }

  @Test
  void aPerspectiveGoesToAnotherRobot() {
    arranging()
        .arrange(arranging().now().adding(new Added("map-2", "map")).with("map-2", new DropTarget.Tab("map", 0)));
    arranging().keep("Two maps");
    String text = arranging().export("Two maps").orElseThrow();
    assertEquals(Optional.empty(), arranging().export("Nothing"));
    arranging().forget("Two maps");
    restart(HEAD.replace("map: {type: map, zoom: 3}", "map: {type: map, zoom: 5}").replace("bell: {type: bell}",
        "map-2: {type: camera}"));
    PerspectiveImport.Kept kept = assertInstanceOf(PerspectiveImport.Kept.class,
        arranging().take(text.replace("type: camera", "type: radar")));
    assertEquals(new PerspectiveImport.Kept("Two maps", List.of("'camera': no view of type 'radar' is installed")),
        kept);
    Arrangement taken = arranging().perspectives().get("Two maps").arrangement();
    // Neither is overwritten: the map here has another zoom, and map-2 here is a camera.
    assertEquals(List.of(new Added("map-3", "map"), new Added("map-4", "map")), taken.added());
    arranging().choose("Two maps");
    bench.await("map-4", RuicState.INITIALIZED);
    assertInstanceOf(PerspectiveImport.Kept.class, arranging().take(text));
    assertEquals(List.of("Two maps", "Two maps 2"), List.copyOf(arranging().perspectives().keySet()));
    assertInstanceOf(PerspectiveImport.Refused.class, arranging().take("ruics: {}"));
  }

  @Test
  void whereAViewWasLeftIsKeptHereAndNotGivenToOthers() {
    arranging().keep("Mine");
    String before = arranging().export("Mine").orElseThrow();
    map.context().settings().set("left", 7.0);
    assertEquals(before, arranging().export("Mine").orElseThrow());
    PerspectiveImport.Kept kept = assertInstanceOf(PerspectiveImport.Kept.class, arranging().take(before));
    assertEquals(List.of(), arranging().perspectives().get(kept.name()).arrangement().added(), "it is the same map");
    restart(YAML);
    assertEquals(7.0, map.context().settings().current().number("left"));
  }

  @Test
  void typesSayWhetherTheyFit() {
    Await.until("the scan is offered", () -> arranging().types().stream().allMatch(ViewFit::fits));
    assertEquals(List.of("camera", "map"), arranging().types().stream().map(ViewFit::type).toList());
  }

  @Test
  void whatCannotBeIsLeftOut() {
    arranging().arrange(new Arrangement(new Layout.Tabs(List.of("map", "nobody", "bell"))));
    assertEquals(List.of("map", "bell"), arranging().now().views());
  }

  @Test
  void aDamagedFileIsSetAside() throws IOException {
    arranging().keep("Usual");
    bench.close();
    Path file = kept().getFirst();
    Files.writeString(file, "pioneer: [");
    bench = open(YAML);
    assertEquals(Set.of("Look"), arranging().perspectives().keySet());
    Await.until("the user is told", () -> bench.alerts.stream().anyMatch(a -> a.contains(".damaged-")));
    arranging().keep("Other");
    restart(YAML);
    assertEquals(Set.of("Look", "Other"), arranging().perspectives().keySet());
    List<Path> aside = kept().stream().filter(f -> f.toString().contains(".damaged-")).toList();
    assertEquals("pioneer: [", Files.readString(aside.getFirst()));
  }

  @Test
  void twoWorkbenchesKeepWhatTheOtherHasChanged() throws IOException {
    arranging().keep("Usual");
    Await.until("it is written", () -> !kept().isEmpty());
    Path file = kept().getFirst();
    Files.writeString(file, Files.readString(file) + "keira: {settings: {map: {zoom: 7}}}\n");
    arranging().keep("Other");
    bench.close();
    assertTrue(Files.readString(file).contains("zoom: 7"));
    bench = open(YAML);
    assertEquals(Set.of("Look", "Other", "Usual"), arranging().perspectives().keySet());
  }

  private List<Path> kept() {
    try (Stream<Path> files = Files.walk(folder.resolve("state").resolve("overlays"))) {
      return files.filter(f -> !f.toString().endsWith(".new") && Files.isRegularFile(f)).sorted().toList();
    } catch (IOException e) {
      return List.of();
    }
  }
}
