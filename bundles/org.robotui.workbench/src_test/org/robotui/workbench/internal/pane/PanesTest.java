package org.robotui.workbench.internal.pane;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import java.util.Optional;
import java.util.Set;
import org.eclipse.swt.SWT;
import org.eclipse.swt.layout.FillLayout;
import org.eclipse.swt.widgets.Composite;
import org.eclipse.swt.widgets.Control;
import org.eclipse.swt.widgets.Display;
import org.eclipse.swt.widgets.Event;
import org.eclipse.swt.widgets.Shell;
import org.eclipse.swt.widgets.Text;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.condition.EnabledIfEnvironmentVariable;
import org.robotui.api.command.Principal;
import org.robotui.api.host.Problem;
import org.robotui.api.host.RuicState;
import org.robotui.api.layout.Layout;
import org.robotui.testkit.Controls;
import org.robotui.testkit.TestDisplay;
import org.robotui.testkit.host.FakeRuic;
import org.robotui.ui.Theme;
import org.robotui.ui.Themes;
import org.robotui.ui.ViewKey;
import org.robotui.ui.control.QuietButton;
import org.robotui.workbench.internal.display.StopKeys;
import org.robotui.workbench.internal.dock.ArrangeHistory;
import org.robotui.workbench.internal.dock.PaintedView;
import org.robotui.workbench.internal.dock.RobotArea;
import org.robotui.workbench.internal.dock.RuicSurface;
import org.robotui.workbench.internal.model.Lease;
import org.robotui.workbench.internal.model.Overview;
import org.robotui.workbench.internal.model.SearchEntry;
import org.robotui.workbench.internal.model.Stops;

@EnabledIfEnvironmentVariable(named = "DISPLAY", matches = ".+")
class PanesTest {
  private static final Principal YOU = new Principal("w", "You", Principal.Kind.WINDOW);

  private static final Stops TWO = new Stops(List.of("Keira", "Natalie"), List.of("Keira", "Natalie"));

  private final NoActions actions = new NoActions();
  private final PaintedView map = new PaintedView("follow");
  private final PaintedView camera = new PaintedView("30 Hz");
  private final FakeRuic ruic =
      new FakeRuic("Keira").in(RuicState.SELECTED, "").view("map", map).view("camera", camera);
  private final ArrangeHistory history = new ArrangeHistory();
  private Display display;
  private Theme theme;
  private Shell shell;

  @BeforeEach
  void open() {
    display = TestDisplay.get();
    theme = Themes.dark(display);
    shell = new Shell(display, SWT.NO_TRIM);
    shell.setLayout(new FillLayout());
    shell.setSize(800, 600);
  }

  @AfterEach
  void close() {
    shell.dispose();
    theme.dispose();
  }

  @Test
  void anUnselectedRobotHasNoControls() {
    RobotArea area = show(new Layout.View("map"));

    area.show(Optional.empty());

    assertTrue(map.control.isDisposed());
    assertTrue(area.surface().isEmpty());
  }

  @Test
  void aViewThatThrowsWhenItIsMadeFailsAlone() {
    camera.throwsOnCreate = true;

    RobotArea area = show(new Layout.Split(Layout.Direction.COLUMN,
        List.of(new Layout.View("map"), new Layout.View("camera")), List.of(1.0, 1.0)));

    assertEquals(List.of("surfaceFailed camera"), ruic.calls());
    assertFalse(map.control.isDisposed());
    press(find(area, MessagePane.class), "");
    assertEquals("restart camera", ruic.calls().getLast());
  }

  @Test
  void aViewThatThrowsWhenItIsRefreshedIsTakenOut() {
    RobotArea area = show(new Layout.View("map"));
    map.throwsOnRefresh = true;

    area.surface().orElseThrow().refresh("map");

    assertTrue(map.control.isDisposed());
    assertEquals(List.of("surfaceFailed map"), ruic.calls());
  }

  @Test
  void anInstanceThatWasRestartedIsShownAnew() {
    RobotArea area = show(new Layout.View("map"));
    PaintedView next = new PaintedView("new");
    ruic.view("map", next);

    area.show(Optional.of(ruic));

    assertTrue(map.control.isDisposed());
    assertEquals(1, next.created);
  }

  @Test
  void aChangeThatDoesNotTouchAViewLeavesItsControl() {
    RobotArea area = show(new Layout.View("map"));

    area.show(Optional.of(ruic));

    assertEquals(1, map.created);
  }

  @Test
  void aFailedRobotSaysWhyAndCanBeRestarted() {
    ruic.in(RuicState.FAILED, "the master is gone");
    RobotArea area = show(new Layout.View("map"));

    press(find(area, MessagePane.class), "");

    assertEquals(List.of("restart Keira"), actions.calls);
  }

  @Test
  void problemsStandAboveViewsThatGoOn() {
    RobotArea area = show(new Layout.View("map"));

    area.problems(List.of(new Problem("a.yaml", 3, 4, Problem.Severity.ERROR, "wrong word")));
    area.layout(true, true);

    ProblemsPane pane = find(area, ProblemsPane.class);
    assertTrue(pane.getSize().y > 40);
    assertEquals(pane.getSize().y, area.surface().orElseThrow().getLocation().y);
    area.problems(List.of());
    assertTrue(pane.isDisposed());
  }

  @Test
  void theBarKeepsItsPlacesWhenTheStopIsLatched() {
    TopBar bar = new TopBar(shell, theme, Menus.ALL, actions);
    shell.layout(true, true);
    LeaseLamp lamp = find(bar, LeaseLamp.class);
    int before = lamp.getLocation().x;

    bar.show(Lease.of(ruic.authorities(), ruic.snapshot().link(), YOU), TWO);
    bar.layout(true);

    assertEquals(before, lamp.getLocation().x);
    press(bar, "Release the stop of Keira, Natalie; nothing moves by that");
    assertEquals(List.of("release"), actions.calls);
  }

  @Test
  void whileOneRobotIsReleasedAndAnotherIsNotTheBarNamesTheOther() {
    TopBar bar = new TopBar(shell, theme, Menus.ALL, actions);
    bar.setSize(1400, 44);
    bar.show(Lease.of(ruic.authorities(), ruic.snapshot().link(), YOU), new Stops(TWO.robots(), List.of("Natalie")));

    assertTrue(TopBarTest.button(bar, "Release the stop of Natalie;").getSize().x > 80);
    assertTrue(Controls.all(bar, ShortenedLabel.class).stream()
        .anyMatch(words -> words.text().equals("Stopped: Natalie") && words.getSize().x > 80));

    bar.show(Lease.of(ruic.authorities(), ruic.snapshot().link(), YOU), TWO);
    assertTrue(Controls.all(bar, ShortenedLabel.class).stream()
        .anyMatch(words -> words.text().equals("Stopped: Keira, Natalie")));
  }

  @Test
  void theSearchTakesTheKeysAtOnceAndGivesThemBack() {
    show(new Layout.View("map"));
    shell.open();
    TestDisplay.until(() -> map.control.forceFocus() && map.control.isFocusControl());

    SearchPane pane = SearchPane.open(shell, theme,
        List.of(new SearchEntry("Robot", "Stop Keira", "F12", () -> actions.calls.add("stop"))));

    assertTrue(display.getFocusControl() instanceof Text,
        "not a moment later: what is typed in between would act in the map");
    assertEquals(1, pane.found().size());
    Event enter = new Event();
    display.getFocusControl().notifyListeners(SWT.DefaultSelection, enter);
    assertEquals(List.of("stop"), actions.calls);
    assertTrue(pane.isDisposed());
    TestDisplay.until(map.control::isFocusControl);
  }

  @Test
  void viewsTellTheirKeys() {
    RuicSurface surface = show(new Layout.View("map")).surface().orElseThrow();

    assertEquals(List.of(new ViewKey("F", "Follow")), surface.views().getFirst().keys());
  }

  @Test
  void theListOfShortcutsTakesThePlaceOfASearch() {
    SearchPane search = SearchPane.open(shell, theme, List.of());
    SearchPane shortcuts =
        SearchPane.openShortcuts(shell, theme, List.of(new SearchEntry("Map", "Follow", "F", () -> {})));

    assertTrue(search.isDisposed());
    assertEquals(List.of("F"), shortcuts.found().stream().map(SearchEntry::keys).toList());
  }

  @Test
  void robotsAreSelectedByKeyAndMouse() {
    Navigator navigator = new Navigator(shell, theme, actions);
    shell.layout(true, true);
    navigator.show(Overview.of(List.of(ruic, new FakeRuic("Natalie")), Set.of()).robots(), Optional.empty(), List.of());
    navigator.layout(true);
    RobotList list = navigator.robots();

    send(list, SWT.MouseDown, e -> {
      e.button = 1;
      e.y = 60;
    });
    send(list, SWT.KeyDown, e -> e.keyCode = SWT.ARROW_UP);
    send(list, SWT.KeyDown, e -> e.character = SWT.CR);

    assertEquals(List.of("select Natalie", "select Keira"), actions.calls);
  }

  @Test
  void spaceStopsInAViewAndF12Everywhere() {
    RobotArea area = show(new Layout.View("map"));
    try (StopKeys keys = new StopKeys(display, actions::stop)) {
      send(map.control, SWT.KeyDown, e -> e.keyCode = ' ');
      send(area, SWT.KeyDown, e -> e.keyCode = ' ');
      send(shell, SWT.KeyDown, e -> e.keyCode = SWT.F12);
    }
    send(shell, SWT.KeyDown, e -> e.keyCode = SWT.F12);

    assertEquals(List.of("stop", "stop"), actions.calls);
  }

  private RobotArea show(Layout layout) {
    ruic.laidOut(layout);
    RobotArea area = new RobotArea(shell, theme, r -> history, actions);
    area.show(Optional.of(ruic));
    shell.open();
    shell.layout(true, true);
    return area;
  }

  private static void press(Composite above, String hint) {
    Controls.all(above, QuietButton.class).stream()
        .filter(b -> hint.equals(Optional.ofNullable(b.getToolTipText()).orElse("")))
        .findFirst().orElseThrow().press();
  }

  private static <C extends Control> C find(Composite above, Class<C> type) {
    return Controls.all(above, type).getFirst();
  }

  private static void send(Control control, int type, java.util.function.Consumer<Event> fill) {
    Event event = new Event();
    fill.accept(event);
    control.notifyListeners(type, event);
  }
}
