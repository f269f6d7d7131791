package org.robotui.core.internal.compose;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertInstanceOf;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.Duration;
import java.util.List;
import java.util.Optional;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.atomic.AtomicInteger;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.robotui.api.Descriptor;
import org.robotui.api.FileKind;
import org.robotui.api.Rfic;
import org.robotui.api.RficContext;
import org.robotui.api.RficType;
import org.robotui.api.RuicType;
import org.robotui.api.config.Schema;
import org.robotui.api.config.Setting;
import org.robotui.api.config.Settings;
import org.robotui.api.config.ValueType;
import org.robotui.api.host.FileOutcome;
import org.robotui.api.host.FileOutcome.NotOpened;
import org.robotui.api.host.FileOutcome.Opened;
import org.robotui.api.host.Ruic;
import org.robotui.api.layout.Arrangement;
import org.robotui.api.layout.DropTarget;
import org.robotui.api.layout.Layout;
import org.robotui.api.link.LinkState;
import org.robotui.api.port.Arity;
import org.robotui.api.port.StreamPort;
import org.robotui.core.internal.support.Await;
import org.robotui.core.internal.support.CoreBench;
import org.robotui.core.internal.support.FakeView;
import org.robotui.data.sensor.Battery;
import org.robotui.data.sensor.LaserScan;

class FileOpeningTest {
  private static final Layout BOTH = new Layout.Split(Layout.Direction.ROW,
      List.of(new Layout.View("scan"), new Layout.View("power")), List.of(2.0, 1.0));

  @TempDir
  Path folder;
  private CoreBench bench;
  private final AtomicInteger open = new AtomicInteger();
  private final AtomicInteger mostOpen = new AtomicInteger();

  /** Files with the word "scan" in them have a scan, those with "damage" are damaged. */
  private final class Tapes implements RficType {
    @Override
    public Descriptor descriptor() {
      return new Descriptor("tape", "Tape", "", Schema.of(Setting.required("file", new ValueType.Text(), "")),
          List.of());
    }

    @Override
    public Optional<FileKind> files() {
      return Optional
          .of(new FileKind("Tapes", List.of("tape", "tape.active"), List.of("reel.yaml", "*_0.reel"), "file"));
    }

    @Override
    public Rfic create(RficContext context, Settings settings) {
      Path file = Path.of(settings.text("file"));
      return new Rfic() {
        @Override
        public void start() {
          mostOpen.accumulateAndGet(open.incrementAndGet(), Math::max);
          play(context, file);
        }

        @Override
        public void close() {
          open.decrementAndGet();
        }
      };
    }
  }

  private static void play(RficContext context, Path file) {
    try {
      String text = Files.readString(Files.isDirectory(file) ? file.resolve("reel.yaml") : file);
      if (text.contains("damage")) {
        context.link().report(new LinkState.Failed("no tape begins like this", Duration.ofSeconds(60)));
        return;
      }
      if (text.contains("scan")) {
        context.offers().stream(new StreamPort<>("front", LaserScan.class, Arity.MANY, ""), wanted -> {});
        context.offers().stream(new StreamPort<>("back", LaserScan.class, Arity.MANY, ""), wanted -> {});
      }
      context.link().report(new LinkState.Connected(file.toString()));
    } catch (IOException e) {
      context.link().report(new LinkState.Failed(e.getMessage(), Duration.ofSeconds(60)));
    }
  }

  /** A type of RUIC with both views. */
  private record Both() implements RuicType {
    @Override
    public Descriptor descriptor() {
      return new Descriptor("both", "Both", "", Schema.EMPTY, List.of());
    }

    @Override
    public List<UicSpec> uics(Settings settings) {
      return UicSpec.of(layout(settings), "text");
    }

    @Override
    public Layout layout(Settings settings) {
      return BOTH;
    }
  }

  @BeforeEach
  void types() {
    bench = new CoreBench(folder);
    bench.registry.add(new Tapes(), "org.robotui.rfic.tape");
    bench.registry.add(new FakeView("scan", new StreamPort<>("scan", LaserScan.class, Arity.ONE, "")), "b");
    bench.registry.add(new FakeView("power", new StreamPort<>("battery", Battery.class, Arity.ONE, "")), "b");
    bench.registry.add(new Both(), "b");
  }

  @AfterEach
  void end() {
    bench.close();
  }

  private Path file(String name, String content) throws IOException {
    return Files.writeString(folder.resolve(name), content);
  }

  private FileOutcome outcome(Path file) throws Exception {
    return bench.core.files().open(file).toCompletableFuture().get(30, TimeUnit.SECONDS);
  }

  private Opened opened(Path file) throws Exception {
    FileOutcome outcome = outcome(file);
    return assertInstanceOf(Opened.class, outcome, outcome::toString);
  }

  private String refused(Path file) throws Exception {
    return assertInstanceOf(NotOpened.class, outcome(file)).reason();
  }

  @Test
  void aFileIsShownByTheViewsThatFit() throws Exception {
    Opened opened = opened(file("Keira 1.tape", "scan"));
    assertEquals(List.of("Keira 1"), opened.ruics());
    assertEquals(List.of(), opened.problems());
    String yaml = Files.readString(opened.configuration());
    assertTrue(yaml.contains("without: [power]"), yaml);
    assertTrue(yaml.contains("scan.scan: tape.back"), yaml);
    assertTrue(opened.configuration().getFileName().toString().startsWith("Keira 1.tape-"));
    assertEquals(List.of("scan"), bench.ruic().layout().views());
    assertEquals(1, mostOpen.get(), "what tries a file has ended before it is shown");
  }

  @Test
  void aFileThatIsOpenedTwiceIsThereOnce() throws Exception {
    Path file = file("a.tape", "scan");
    Opened first = opened(file);
    assertEquals(first, opened(file));
    assertEquals(1, bench.core.ruics().size());
  }

  @Test
  void aFileThatWasClosedIsShownAsTheUserLeftIt() throws Exception {
    Path file = file("a.tape", "scan");
    Opened first = opened(file);
    Ruic ruic = bench.ruic();
    ruic.arranging().arrange(ruic.arranging().now().adding(new Arrangement.Added("power", "power"))
        .with("power", new DropTarget.Tab("scan", 1)));
    Await.until("the view is there", () -> ruic.layout().views().contains("power"));
    ruic.remove().toCompletableFuture().get(10, TimeUnit.SECONDS);
    Await.until("it has gone", () -> bench.core.ruics().isEmpty());
    assertEquals(first, opened(file));
    assertTrue(bench.ruic().layout().views().contains("power"));
  }

  @Test
  void twoFilesOfOneNameHaveTwoConfigurations() throws Exception {
    Files.createDirectories(folder.resolve("other"));
    assertEquals(List.of("a"), opened(file("a.tape", "scan")).ruics());
    assertEquals(List.of("a 2"), opened(file("other/a.tape", "scan")).ruics());
  }

  @Test
  void theLongestExtensionIsNotPartOfTheName() throws Exception {
    assertEquals(List.of("a.b"), opened(file("a.b.TAPE.active", "scan")).ruics());
  }

  @Test
  void aFolderIsOpenedByItselfAndByTheFileThatDescribesIt() throws Exception {
    Path run = Files.createDirectories(folder.resolve("Run 2026.11"));
    Opened first = opened(file("Run 2026.11/reel.yaml", "scan"));
    assertEquals(List.of("Run 2026.11"), first.ruics());
    assertEquals(first.configuration(), opened(run).configuration());
    assertEquals(1, bench.core.ruics().size());
    Files.move(run.resolve("reel.yaml"), run.resolve("a_0.reel"));
    assertEquals(first.configuration(), opened(run).configuration());
    assertTrue(refused(file("Run 2026.11/other.yaml", "scan")).startsWith("no robot interface"));
  }

  @Test
  void aDamagedFileSaysWhatIsWrongAndLeavesNothing() throws Exception {
    Path file = file("a.tape", "damage");
    assertEquals(file + " cannot be opened: no tape begins like this", refused(file));
    assertEquals(List.of(), bench.core.ruics());
    Files.writeString(file, "scan");
    assertEquals(List.of("a"), opened(file).ruics());
  }

  @Test
  void whatCannotBeOpenedIsRefusedWithTheReason() throws Exception {
    assertEquals("there is no file " + folder.resolve("b.tape"), refused(folder.resolve("b.tape")));
    String none = refused(folder);
    assertTrue(none.contains("opens the folder " + folder) && none.contains("folders with reel.yaml or *_0.reel"),
        none);
    String reason = refused(file("${HOME}.tape", "scan"));
    assertTrue(reason.endsWith("rename it"), reason);
    assertTrue(
        refused(file("empty.tape", "nothing")).endsWith("has nothing that a view which is installed could show"));
  }

  @Test
  void whatNoTypeOpensNamesWhatCouldBe() throws Exception {
    String reason = refused(file("a.wav", "scan"));
    assertTrue(reason.endsWith("files that are opened end with .tape, .tape.active, folders with reel.yaml or *_0.reel"
        + " in them, and configurations with .yaml"),
        reason);
  }

  @Test
  void aTypeThatComesLaterIsWaitedFor() throws Exception {
    Tapes late = new Tapes();
    try (CoreBench other = new CoreBench(folder.resolve("other"))) {
      var outcome = other.core.files().open(file("a.tape", "scan")).toCompletableFuture();
      other.registry.add(new FakeView("scan", new StreamPort<>("scan", LaserScan.class, Arity.ONE, "")), "b");
      other.registry.add(new Both(), "b");
      other.registry.add(late, "org.robotui.rfic.tape");
      FileOutcome came = outcome.get(30, TimeUnit.SECONDS);
      assertInstanceOf(Opened.class, came, came::toString);
    }
  }

  @Test
  void whereCoreHasEndedNothingIsOpened() throws Exception {
    Path file = file("a.tape", "scan");
    bench.close();
    assertEquals(file + " is not opened, as RobotUI ends", refused(file));
  }
}
