package org.robotui.uic.diagnostics.internal;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.stream.Stream;
import org.eclipse.swt.SWT;
import org.eclipse.swt.layout.FillLayout;
import org.eclipse.swt.widgets.Composite;
import org.eclipse.swt.widgets.Control;
import org.eclipse.swt.widgets.Event;
import org.eclipse.swt.widgets.Scrollable;
import org.eclipse.swt.widgets.Shell;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.condition.EnabledIf;
import org.robotui.api.port.SourceId;
import org.robotui.data.status.Diagnostics;
import org.robotui.testkit.Displays;
import org.robotui.testkit.FakeUicContext;
import org.robotui.testkit.TestDisplay;
import org.robotui.ui.PaintedCanvas;
import org.robotui.ui.Theme;
import org.robotui.ui.Themes;
import org.robotui.ui.UiContext;
import org.robotui.ui.control.QuietButton;

@EnabledIf(value = Displays.AVAILABLE, disabledReason = Displays.REASON)
class DiagnosticsSwtTest {
  private static final long SECOND = 1_000_000_000L;
  private static final SourceId SOURCE = new SourceId("base", "/diagnostics");

  private final Theme theme = Themes.dark(TestDisplay.get());
  private final Shell shell = new Shell(TestDisplay.get(), SWT.NO_TRIM);
  private final FakeUicContext context = new FakeUicContext("diagnostics", new DiagnosticsType().schema());
  private DiagnosticsUic uic;
  private String note = "";

  @BeforeEach
  void open() {
    shell.setLayout(new FillLayout());
    shell.setSize(700, 500);
    uic = new DiagnosticsUic(context);
    uic.createControl(shell, UiContext.of(theme, text -> note = text));
    shell.open();
    shell.layout(true, true);
  }

  @AfterEach
  void close() {
    shell.dispose();
    theme.dispose();
  }

  @Test
  void groupsAreOpenedByTheirArrowAndStayOpenInTheSettings() {
    say(1, Diagnostics.Level.OK);
    press(20, 10, 1);
    assertEquals(List.of("base./diagnostics/Robot"), context.settings().current().list(DiagnosticsType.CLOSED));
    press(20, 10, 2);
    assertEquals(List.of("base./diagnostics/Robot"), context.settings().current().list(DiagnosticsType.OPENED));
    assertEquals(List.of(), context.settings().current().list(DiagnosticsType.CLOSED));
  }

  @Test
  void aClickOnAStripShowsThatMomentAndThePillLeadsBack() {
    say(300, Diagnostics.Level.ERROR);
    say(600, Diagnostics.Level.OK);
    assertTrue(Stream.of(list().getParent().getChildren()).filter(QuietButton.class::isInstance)
        .noneMatch(Control::getVisible));
    press(700 - 12 - 75, 36, 600);
    assertTrue(pill().getVisible());
    pill().press();
    tick(600);
    assertTrue(Stream.of(list().getParent().getChildren()).filter(QuietButton.class::isInstance)
        .noneMatch(Control::getVisible));
  }

  @Test
  void theTitleCountsThePartsAndNamesTheSource() {
    say(1, Diagnostics.Level.OK);
    assertEquals("1 part  base./diagnostics", note);
  }

  @Test
  void settingsAreReadAtTheBeginning() {
    context.settings().set(DiagnosticsType.PROBLEMS, true);
    context.settings().set(DiagnosticsType.OPENED, List.of("a"));
    assertTrue(DiagnosticsPreferences.read(context.settings().current()).problems());
    assertTrue(DiagnosticsPreferences.read(context.settings().current()).isOpen("a", 3));
  }

  private void say(int second, Diagnostics.Level level) {
    context.input(DiagnosticsType.DIAGNOSTICS).put(SOURCE,
        new Diagnostics(
            List.of(new Diagnostics.Item("/Robot/Motor", "", level, "message", Map.of("Temperature", "40")))),
        second * SECOND,
        Optional.empty());
    tick(second);
  }

  private void tick(int second) {
    uic.tick(second * SECOND);
    uic.refresh();
  }

  private QuietButton pill() {
    return Stream.of(list().getParent().getChildren()).filter(QuietButton.class::isInstance)
        .map(QuietButton.class::cast).findFirst().orElseThrow();
  }

  private Scrollable list() {
    return all(shell).filter(PaintedCanvas.class::isInstance).map(Scrollable.class::cast)
        .filter(c -> c.getVerticalBar() != null)
        .filter(c -> Stream.of(c.getParent().getChildren()).anyMatch(QuietButton.class::isInstance)).findFirst()
        .orElseThrow();
  }

  private static Stream<Control> all(Control control) {
    return control instanceof Composite composite
        ? Stream.concat(Stream.of(control), Stream.of(composite.getChildren()).flatMap(DiagnosticsSwtTest::all))
        : Stream.of(control);
  }

  private void press(int x, int y, int second) {
    Event down = new Event();
    down.button = 1;
    down.x = x;
    down.y = y;
    list().notifyListeners(SWT.MouseDown, down);
    tick(second);
  }
}
