package org.robotui.workbench.internal.timeline;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.Arrays;
import java.util.List;
import java.util.Optional;
import java.util.stream.Stream;
import org.eclipse.swt.SWT;
import org.eclipse.swt.layout.GridData;
import org.eclipse.swt.layout.GridLayout;
import org.eclipse.swt.widgets.Composite;
import org.eclipse.swt.widgets.Control;
import org.eclipse.swt.widgets.Event;
import org.eclipse.swt.widgets.Label;
import org.eclipse.swt.widgets.Shell;
import org.eclipse.swt.widgets.Text;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.condition.EnabledIfEnvironmentVariable;
import org.robotui.api.replay.Bookmark;
import org.robotui.api.replay.ComparisonWish;
import org.robotui.api.replay.TimeRange;
import org.robotui.api.replay.TimelineState;
import org.robotui.api.time.PointedTime;
import org.robotui.testkit.TestDisplay;
import org.robotui.ui.PaintedCanvas;
import org.robotui.ui.Theme;
import org.robotui.ui.Themes;
import org.robotui.ui.control.QuietButton;

@EnabledIfEnvironmentVariable(named = "DISPLAY", matches = ".+")
class TimelineBarTest {
  private static final int WIDTH = 1000;
  private static final long BEGIN = PretendTimeline.BEGIN;
  private static final long SECOND = PretendTimeline.SECOND;

  private final PretendTimeline timeline = new PretendTimeline().filled();
  private final Theme theme = Themes.dark(TestDisplay.get());
  private final Shell shell = new Shell(TestDisplay.get(), SWT.NO_TRIM);
  private final LiveTimeline live = new LiveTimeline(Runnable::run);
  private final PointedTime pointed = new PointedTime();
  private final BarState state = new BarState(pointed);
  private final PretendSearch service = new PretendSearch();
  private final EventSearch search = new EventSearch(Runnable::run, Runnable::run, () -> Optional.of(service));
  private final RecordingCalls calls = new RecordingCalls(Runnable::run, Runnable::run);
  private final RunCompare compare =
      new RunCompare(calls, () -> Optional.of(PretendComparison.CIRCLE));
  private final TrackAnalysis analysis = new TrackAnalysis(calls, Optional::empty, Optional::empty, Optional::empty);
  private TimelineBar bar;

  @BeforeEach
  void open() {
    shell.setLayout(new GridLayout(1, false));
    bar = new TimelineBar(shell, theme, live, search, compare, analysis, state);
    bar.setLayoutData(new GridData(SWT.FILL, SWT.BOTTOM, true, true));
    live.follow(Optional.of(timeline));
    shell.setBounds(0, 0, WIDTH, 500);
    shell.open();
    TestDisplay.until(() -> strip().paints() > 0);
  }

  @AfterEach
  void close() {
    shell.dispose();
    theme.dispose();
  }

  private static Stream<Control> all(Control control) {
    return control instanceof Composite parent
        ? Stream.concat(Stream.of(control), Arrays.stream(parent.getChildren()).flatMap(TimelineBarTest::all))
        : Stream.of(control);
  }

  private List<PaintedCanvas> canvases() {
    return all(bar).filter(PaintedCanvas.class::isInstance).map(PaintedCanvas.class::cast).toList();
  }

  private PaintedCanvas lanes() {
    return canvases().getFirst();
  }

  private PaintedCanvas strip() {
    return canvases().getLast();
  }

  private QuietButton button(String hint) {
    return named(all(bar).toList(), hint);
  }

  private List<String> texts() {
    return all(bar).filter(Text.class::isInstance).map(t -> ((Text) t).getText()).toList();
  }

  private void mouse(Control on, int type, int button, int x, int y) {
    Event event = new Event();
    event.button = button;
    event.x = x;
    event.y = y;
    on.notifyListeners(type, event);
  }

  private void wheel(Control on, int x, int count, int mask) {
    Event event = new Event();
    event.x = x;
    event.count = count;
    event.stateMask = mask;
    event.doit = true;
    on.notifyListeners(SWT.MouseVerticalWheel, event);
  }

  private void press(Control on, int key, int mask) {
    Event event = new Event();
    event.keyCode = key;
    event.stateMask = mask;
    on.notifyListeners(SWT.KeyDown, event);
  }

  private int x(long seconds) {
    return state.scale(strip().getSize().x).x(BEGIN + seconds * SECOND);
  }

  @Test
  void itIsThereOnlyWhileARecordingIsOpen() {
    assertTrue(bar.getSize().y > 60);
    timeline.empty();
    assertEquals(0, bar.computeSize(SWT.DEFAULT, SWT.DEFAULT).y);
    assertFalse(bar.getVisible());
  }

  @Test
  void buttonsPlayStepAndLoop() {
    button("Play").press();
    button("Pause").press();
    button("Step on").press();
    button("Step back").press();
    button("Begin again").press();
    assertEquals(List.of("play", "pause", "step on", "step back", "loop true"), timeline.asked);
    assertTrue(button("Begin again").isChecked());
  }

  @Test
  void thePositionIsShownInTwoWays() {
    timeline.seek(BEGIN + 90 * SECOND + 1_500_000);
    assertEquals("90.002\u00a0s", texts().getLast());
    assertTrue(texts().getFirst().matches("2023-11-1\\d \\d\\d:\\d\\d:50\\.001"), texts().getFirst());
  }

  @Test
  void scrubbingSeeksToTheNewestPlaceOnly() {
    mouse(strip(), SWT.MouseDown, 1, x(30), 25);
    for (int second = 31; second <= 60; second++) {
      mouse(strip(), SWT.MouseMove, 0, x(second), 25);
    }
    mouse(strip(), SWT.MouseUp, 1, x(60), 25);
    TestDisplay.until(() -> !timeline.asked.isEmpty());
    assertEquals(1, timeline.asked.size());
    assertEquals(60, (timeline.state().position() - BEGIN) / (double) SECOND, 0.5);
    mouse(strip(), SWT.MouseMove, 0, x(90), 25);
    assertEquals(1, timeline.asked.size());
  }

  @Test
  void whereTheUserPointsInAViewIsShownAndThePointerIsToldToViews() {
    long before = strip().paints();
    pointed.point(this, BEGIN + 30 * SECOND);
    TestDisplay.until(() -> strip().paints() > before);
    assertEquals(x(30), state.elsewhere(state.scale(strip().getSize().x)).orElseThrow());
    mouse(strip(), SWT.MouseMove, 0, x(60), 25);
    assertEquals(60, (pointed.elsewhere(this).orElseThrow() - BEGIN) / (double) SECOND, 0.5);
    assertTrue(state.elsewhere(state.scale(strip().getSize().x)).isEmpty());
    mouse(strip(), SWT.MouseExit, 0, 0, 0);
    assertTrue(pointed.elsewhere(this).isEmpty());
  }

  @Test
  void theEndsOfWhatIsPlayedAreDragged() {
    mouse(strip(), SWT.MouseDown, 1, x(300) + 2, 25);
    mouse(strip(), SWT.MouseMove, 0, x(200), 25);
    mouse(strip(), SWT.MouseUp, 1, x(200), 25);
    TimeRange played = timeline.state().range().orElseThrow();
    assertEquals(BEGIN, played.start());
    assertEquals(200, (played.end() - BEGIN) / (double) SECOND, 0.5);
    assertEquals(0, timeline.state().position() - BEGIN);
  }

  @Test
  void aBookmarkIsJumpedToExactly() {
    timeline.mark(new Bookmark(BEGIN + 123 * SECOND + 7, "door"));
    mouse(strip(), SWT.MouseDown, 1, x(123) + 1, StripPaint.MARKS + 4);
    assertEquals(BEGIN + 123 * SECOND + 7, timeline.state().position());
  }

  @Test
  void keysWorkWhereTheBarHasTheFocus() {
    press(strip(), ' ', 0);
    press(strip(), SWT.ARROW_RIGHT, 0);
    press(strip(), SWT.ARROW_RIGHT, SWT.MOD1);
    press(strip(), SWT.PAGE_DOWN, 0);
    press(strip(), SWT.HOME, 0);
    press(strip(), SWT.ARROW_UP, 0);
    assertEquals(List.of("play", "step on", "seek " + SECOND, "seek " + 11 * SECOND, "seek 0", "speed 2.0"),
        timeline.asked);
  }

  @Test
  void theTabulatorLeavesIt() {
    for (PaintedCanvas canvas : canvases()) {
      assertTrue(traverses(canvas, SWT.TRAVERSE_TAB_NEXT));
      assertFalse(traverses(canvas, SWT.TRAVERSE_ARROW_NEXT));
    }
  }

  private static boolean traverses(Control control, int detail) {
    Event event = new Event();
    event.detail = detail;
    control.notifyListeners(SWT.Traverse, event);
    return event.doit;
  }

  @Test
  void ctrlAndTheWheelZoomAtThePointerAndTheWheelAloneMoves() {
    int x = x(100);
    wheel(strip(), x, 9, SWT.MOD1);
    assertTrue(state.isZoomed());
    assertEquals(x, x(100), 1);
    long from = state.scale(WIDTH).shown().start();
    wheel(strip(), x, -3, 0);
    assertTrue(state.scale(WIDTH).shown().start() > from);
    press(strip(), '0', 0);
    assertFalse(state.isZoomed());
  }

  @Test
  void theRecordingsAreShownAboveWhereTheUserWantsThem() {
    int before = bar.getSize().y;
    button("Show the recordings").press();
    TestDisplay.until(() -> lanes().paints() > 0);
    assertEquals(before + 9 * LaneRows.HEIGHT, bar.getSize().y);
    mouse(lanes(), SWT.MouseDown, 1, 40, 5 * LaneRows.HEIGHT - 4);
    button("Step on").press();
    assertEquals(List.of("step on /base_scan"), timeline.asked);
    mouse(lanes(), SWT.MouseDown, 1, 40, 4);
    assertEquals(10, state.rows().rows().size());
  }

  @Test
  void laggingAndProblemsAreSaidInWords() {
    assertTrue(button("husky.mcap: the last chunk").isVisible());
    timeline.set(new TimelineState(timeline.state().span(), BEGIN, true, 5, false, Optional.empty(), List.of(), true));
    assertTrue(all(bar).anyMatch(c -> c instanceof Label label
        && label.getText().equals("lagging: slower than 5\u00d7")));
  }

  private List<Control> inFindWindow() {
    button("Find when").press();
    return Arrays.stream(shell.getShells()).filter(s -> s.getText().equals("Find in Recordings"))
        .flatMap(TimelineBarTest::all)
        .toList();
  }

  private static QuietButton named(List<Control> controls, String hint) {
    return controls.stream().filter(QuietButton.class::isInstance).map(QuietButton.class::cast)
        .filter(b -> String.valueOf(b.getToolTipText()).startsWith(hint)).findFirst().orElseThrow();
  }

  private void search(List<Control> window, String condition) {
    Text field = (Text) window.stream().filter(Text.class::isInstance).findFirst().orElseThrow();
    field.setText(condition);
    field.notifyListeners(SWT.DefaultSelection, new Event());
  }

  @Test
  void whatIsFoundIsListedAndMarkedAndGoesWithItsRecording() {
    service.events = List.of(PretendSearch.event(PretendTimeline.KEIRA, 100, 110, "battery.charge is 0.1"),
        PretendSearch.event(PretendTimeline.HUSKY, 70, 71, "battery.charge is 0.2"));
    List<Control> window = inFindWindow();
    search(window, "bad words");
    assertEquals(List.of(), state.found(), "what cannot be read is not searched for");
    search(window, "battery charge < 0.3");
    assertEquals(List.of("husky.mcap", "keira-with-a-rather-long-name_2026-11-27.bag"),
        state.found().stream().map(FoundRow::file).toList());
    assertEquals(BEGIN + 70 * SECOND, state.found().getFirst().range().start());
    assertTrue(new StripPaint(theme, state).hint(state.scale(WIDTH), x(105)).endsWith("battery.charge is 0.1"));
    timeline.shift(PretendTimeline.HUSKY, 60 * SECOND);
    assertEquals(List.of(100L, 130L),
        state.found().stream().map(row -> (row.range().start() - BEGIN) / SECOND).toList());
    named(window, "Keep all").press();
    assertEquals(List.of("battery.charge is 0.1", "battery.charge is 0.2"),
        timeline.state().bookmarks().stream().map(Bookmark::note).toList());
    named(window, "Forget").press();
    assertEquals(List.of(), state.found());
  }

  private List<Control> inCompareWindow() {
    button("Compare two").press();
    return Arrays.stream(shell.getShells()).filter(s -> s.getText().equals("Compare Recordings"))
        .flatMap(TimelineBarTest::all).toList();
  }

  @Test
  void twoRecordingsAreComparedByATopicOfBoth() {
    List<Control> window = inCompareWindow();
    search(window, "imu");
    assertTrue(compare.standing().words().startsWith("keira.mcap has no topic 'imu'"), compare.standing().words());
    search(window, "odom linear.x");
    assertEquals("1834 pairs of 2000 and 1834 values", compare.standing().words());
    ComparisonWish wish = compare.standing().wish().orElseThrow();
    assertEquals(List.of(PretendTimeline.HUSKY, PretendTimeline.KEIRA), List.of(wish.first(), wish.second()));
    assertEquals("odom linear.x", wish.topic());
    assertEquals(ComparisonWish.Pairing.TIME, wish.pairing());
    assertEquals(window, inCompareWindow(), "it is one window");
    bar.compare().propose(timeline.tracks().getFirst(), "/odom");
    search(window, "odom");
    assertEquals(List.of(PretendTimeline.KEIRA, PretendTimeline.HUSKY),
        List.of(compare.standing().wish().orElseThrow().first(), compare.standing().wish().orElseThrow().second()));
  }
}
