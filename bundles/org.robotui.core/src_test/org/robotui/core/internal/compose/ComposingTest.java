package org.robotui.core.internal.compose;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertInstanceOf;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.Duration;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.robotui.api.Descriptor;
import org.robotui.api.RuicType;
import org.robotui.api.config.Schema;
import org.robotui.api.config.Setting;
import org.robotui.api.config.Settings;
import org.robotui.api.config.ValueType;
import org.robotui.api.host.Composition;
import org.robotui.api.host.CompositionState.Stage;
import org.robotui.api.host.CompositionText;
import org.robotui.api.host.CompositionText.Field;
import org.robotui.api.host.CompositionText.Refused;
import org.robotui.api.host.CompositionText.Text;
import org.robotui.api.host.InterfaceConfig;
import org.robotui.api.host.RuicDraft;
import org.robotui.api.host.ViewFit;
import org.robotui.api.host.ViewFit.Fit;
import org.robotui.api.layout.Layout;
import org.robotui.api.link.LinkState;
import org.robotui.api.port.Arity;
import org.robotui.api.port.BrowsePort;
import org.robotui.api.port.Intake;
import org.robotui.api.port.SourceId;
import org.robotui.api.port.StreamPort;
import org.robotui.core.internal.support.Await;
import org.robotui.core.internal.support.CoreBench;
import org.robotui.core.internal.support.FakeRobot;
import org.robotui.core.internal.support.FakeView;
import org.robotui.data.Data;
import org.robotui.data.sensor.Battery;
import org.robotui.data.sensor.LaserScan;

class ComposingTest {
  @TempDir
  Path folder;
  private CoreBench bench;
  private final FakeRobot robot = new FakeRobot("fake").onStart(c -> {
    c.offers().stream(new StreamPort<>("laser:0", LaserScan.class, Arity.MANY, ""), wanted -> {});
    c.offers().stream(new StreamPort<>("laser:1", LaserScan.class, Arity.MANY, ""), wanted -> {});
    c.link().report(new LinkState.Connected("here"));
  });

  /** A type of RUIC with views in two tabs, or one that a setting names. */
  private record Type(String id, Layout layout) implements RuicType {
    @Override
    public Descriptor descriptor() {
      Schema schema = layout instanceof Layout.View v ? Schema.of(Setting.of("view", new ValueType.Text(), v.uic(), ""))
          : Schema.EMPTY;
      return new Descriptor(id, id, "", schema, List.of());
    }

    @Override
    public List<UicSpec> uics(Settings settings) {
      return UicSpec.of(layout(settings), "text");
    }

    @Override
    public Layout layout(Settings settings) {
      return layout instanceof Layout.View ? new Layout.View(settings.text("view")) : layout;
    }
  }

  @BeforeEach
  void types() {
    bench = new CoreBench(folder);
    bench.registry.add(robot, "org.robotui.rfic.fake");
    view(new FakeView("scan", new StreamPort<>("scan", LaserScan.class, Arity.ONE, "")));
    view(new FakeView("all", new StreamPort<>("all", LaserScan.class, Arity.MANY, "")));
    view(new FakeView("plot", new StreamPort<>("values", Data.class, Arity.MANY, "", Intake.CHOSEN)));
    view(new FakeView("power", new StreamPort<>("battery", Battery.class, Arity.MANY, "")));
    view(new FakeView("topics", new BrowsePort("graph", Arity.MANY, ""),
        new StreamPort<>("any", LaserScan.class, Arity.MANY, "")));
    view(new FakeView("frames"));
    view(new FakeView("text", new StreamPort<>("all", Data.class, Arity.MANY, ""))
        .on(org.robotui.api.UicType.Surface.TEXT));
    bench.registry.add(new Type("rover", new Layout.Split(Layout.Direction.ROW,
        List.of(new Layout.Tabs(List.of("all", "plot", "topics")), new Layout.View("scan")), List.of(2.0, 1.0))), "b");
    bench.registry.add(new Type("single", new Layout.View("all")), "b");
    bench.registry.add(new Type("other", new Layout.Tabs(List.of("power", "topics", "frames"))), "b");
  }

  private void view(FakeView view) {
    bench.registry.add(view, "org.robotui.uic.fake");
  }

  @AfterEach
  void end() {
    bench.close();
  }

  private Composition composition(Map<String, Object> settings) {
    Composition composition = bench.core.compose(new InterfaceConfig("base", "fake", "", "", settings));
    Await.until("all is found", () -> composition.state().stage() == Stage.FOUND);
    return composition;
  }

  private RuicDraft draft(String name, String ruic, String file, String... views) {
    return new RuicDraft(name, ruic, List.of(views), Map.of(), folder.resolve(file));
  }

  private static String added(Composition composition, RuicDraft draft) {
    return assertInstanceOf(Text.class, composition.text(draft), () -> composition.text(draft).toString()).added();
  }

  private static void refused(CompositionText text, Field field, String part) {
    Refused refused = assertInstanceOf(Refused.class, text);
    assertEquals(field, refused.field());
    assertTrue(refused.reason().contains(part), refused::reason);
  }

  @Test
  void everyViewSaysHowItFitsAndWhyAndTheBestTypeComesFirst() {
    try (Composition composition = composition(Map.of())) {
      Map<String, Fit> fits = new LinkedHashMap<>();
      composition.state().views().forEach(v -> fits.put(v.type(), v.fit()));

      assertEquals(Map.of("all", Fit.CONNECTED, "plot", Fit.CONNECTED, "frames", Fit.CONNECTED, "scan", Fit.AMBIGUOUS,
          "power", Fit.MISSING, "topics", Fit.MISSING), fits);
      assertEquals("all from laser:0 and laser:1", reason(composition, "all"));
      assertEquals("scan: 2 ports fit", reason(composition, "scan"));
      assertTrue(
          reason(composition, "power").contains("power needs Battery on 'battery'; base offers LaserScan 'laser:0'"),
          reason(composition, "power"));
      assertTrue(reason(composition, "topics").contains("base has no browser"), reason(composition, "topics"));
      assertEquals(List.of("rover", "single", "other"),
          composition.state().ruics().stream().map(r -> r.type()).toList());
      assertEquals("brings 3 of the 4 views that fit; 1 of its views would stay empty",
          composition.state().ruics().getFirst().reason());
    }
  }

  private static String reason(Composition composition, String view) {
    return composition.state().view(view).map(ViewFit::reason).orElseThrow();
  }

  @Test
  void whatIsWrittenRunsAndShowsWhatWasChosen() {
    try (Composition composition = composition(Map.of("peer", "007"))) {
      RuicDraft draft = new RuicDraft("Keira", "rover", List.of("all", "plot", "scan"),
          Map.of(new SourceId("scan", "scan"), new SourceId("base", "laser:1")), folder.resolve("keira.yaml"));
      Text shown = assertInstanceOf(Text.class, composition.text(draft));
      assertTrue(shown.isNew());
      assertEquals(shown, composition.write(draft, shown));
    }
    assertEquals(List.of(), bench.core.load(folder.resolve("keira.yaml")));
    Await.until("the connection", () -> bench.match("scan.scan")
        .filter(m -> m.peers().equals(List.of(new SourceId("base", "laser:1")))).isPresent());
    assertEquals(List.of("all", "plot", "scan"), bench.ruic().layout().views());
    assertEquals("007", bench.ruic().interfaces().getFirst().settings().get("peer"));
    assertEquals(2, robot.closed.get() + 1, "the one that was tried has ended");
  }

  @Test
  void noMoreIsWrittenThanTheTypeDoesNotSayAlready() throws IOException {
    try (Composition composition = composition(Map.of())) {
      assertEquals("  Keira:\n    type: rover\n    rfics:\n      base: {type: fake}\n",
          added(composition, draft("Keira", "rover", "a.yaml", "all", "plot", "topics", "scan"))
              .replaceFirst("(?s).*ruics:\n", ""));
      assertTrue(added(composition, draft("Keira", "single", "a.yaml", "scan"))
          .contains("    type: single\n    view: scan\n"));
      String more = added(composition, draft("Keira", "rover", "a.yaml", "all", "scan", "frames"));
      assertTrue(more.contains(
          "    without: [plot, topics]\n    uics:\n      frames: {}\n    layout:\n      row:\n        - weight: 2\n          tabs: [all, frames]\n"
              + "        - weight: 1\n          view: scan\n"),
          more);
    }
  }

  @Test
  void itIsAddedToAFileWhichStaysAsItWas() throws IOException {
    Path file = Files.writeString(folder.resolve("team.yaml"),
        "# ours\nruics:\n  A: {type: single, rfics: {b: {type: fake}}}   # the first\n");
    try (Composition composition = composition(Map.of())) {
      RuicDraft draft = draft("Keira", "single", "team.yaml", "all");
      Text shown = assertInstanceOf(Text.class, composition.text(draft));
      assertFalse(shown.isNew());
      composition.write(draft, shown);
      assertEquals(
          "# ours\nruics:\n  A: {type: single, rfics: {b: {type: fake}}}   # the first\n  Keira:\n    type: single\n    rfics:\n"
              + "      base: {type: fake}\n",
          Files.readString(file));
      refused(composition.text(draft), Field.NAME, "there is a 'Keira' in team.yaml already");
      assertEquals(List.of("team.yaml"), files(), "nothing else is left in the folder");
    }
  }

  private List<String> files() throws IOException {
    try (var all = Files.list(folder)) {
      return all.map(p -> p.getFileName().toString()).filter(n -> !n.equals("state")).sorted().toList();
    }
  }

  @Test
  void nothingIsWrittenOverWhatCameOrChangedMeanwhile() throws IOException {
    try (Composition composition = composition(Map.of())) {
      RuicDraft draft = draft("Keira", "single", "k.yaml", "all");
      Text shown = assertInstanceOf(Text.class, composition.text(draft));
      Files.writeString(folder.resolve("k.yaml"), "ruics:\n  B: {type: single, rfics: {b: {type: fake}}}\n");
      refused(composition.write(draft, shown), Field.FILE, "look again");
      assertTrue(Files.readString(folder.resolve("k.yaml")).startsWith("ruics:\n  B:"));
    }
  }

  @Test
  void whatIsWrongIsSaidWithTheFieldAndTheRemedy() throws IOException {
    Files.writeString(folder.resolve("flow.yaml"), "ruics: {A: {type: single, rfics: {b: {type: fake}}}}\n");
    Files.writeString(folder.resolve("broken.yaml"), "ruics: [\n");
    bench.load("ruics:\n  Runs: {type: single, rfics: {b: {type: fake}}}\n");
    try (Composition composition = composition(Map.of())) {
      refused(composition.text(draft(" ", "rover", "a.yaml", "all")), Field.NAME, "needs a name");
      refused(composition.text(draft("a/b", "rover", "a.yaml", "all")), Field.NAME, "none of / $ { }");
      refused(composition.text(draft("Runs", "rover", "a.yaml", "all")), Field.NAME, "runs already");
      refused(composition.text(draft("K", "rover", "a.yaml")), Field.VIEWS, "at least one view");
      refused(composition.text(draft("K", "rovr", "a.yaml", "all")), Field.VIEWS, "there are other, rover, single");
      refused(composition.text(draft("K", "rover", "a.txt", "all")), Field.FILE, "ends with .yaml");
      refused(composition.text(draft("K", "rover", "no/a.yaml", "all")), Field.FILE, "there is no folder");
      refused(composition.text(draft("K", "rover", "flow.yaml", "all")), Field.FILE,
          "flow.yaml:1: 'ruics' stands in braces");
      refused(composition.text(draft("K", "rover", "broken.yaml", "all")), Field.FILE,
          "has an error, which comes first");
    }
  }

  @Test
  void aRobotThatIsNotReachedIsSaidAndWhatItsTypeAlwaysOffersIsKnown() {
    robot.onStart(c -> c.link().report(new LinkState.Failed("connection refused", Duration.ofSeconds(2))));
    try (Composition composition = bench.core.compose(new InterfaceConfig("base", "fake", "", "", Map.of()))) {
      Await.until("it is unreached", () -> composition.state().stage() == Stage.UNREACHED);
      assertFalse(composition.state().usable());
      assertTrue(composition.state().sentence().contains("connection refused"), composition.state()::sentence);
    }
    robot.ports(new StreamPort<>("scan", LaserScan.class, Arity.MANY, ""));
    try (Composition composition = bench.core.compose(new InterfaceConfig("base", "fake", "", "", Map.of()))) {
      Await.until("it is known", () -> composition.state().stage() == Stage.KNOWN);
      assertTrue(composition.state().usable());
      assertEquals(Fit.CONNECTED, composition.state().view("scan").orElseThrow().fit());
    }
    try (Composition composition =
        bench.core.compose(new InterfaceConfig("base", "fake", "", "", Map.of("pear", "x")))) {
      Await.until("it has failed", () -> composition.state().stage() == Stage.FAILED);
      assertTrue(composition.state().sentence().contains("pear"), composition.state()::sentence);
    }
  }
}
