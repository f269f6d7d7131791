package org.robotui.uic.log.internal;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import java.util.stream.Stream;
import org.eclipse.swt.SWT;
import org.eclipse.swt.layout.FillLayout;
import org.eclipse.swt.widgets.Composite;
import org.eclipse.swt.widgets.Control;
import org.eclipse.swt.widgets.Event;
import org.eclipse.swt.widgets.Scrollable;
import org.eclipse.swt.widgets.Shell;
import org.eclipse.swt.widgets.Text;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.condition.EnabledIf;
import org.robotui.data.status.LogEntry;
import org.robotui.data.status.Severity;
import org.robotui.testkit.Displays;
import org.robotui.testkit.FakeUicContext;
import org.robotui.testkit.TestDisplay;
import org.robotui.ui.PaintedCanvas;
import org.robotui.ui.Theme;
import org.robotui.ui.Themes;
import org.robotui.ui.UiContext;
import org.robotui.ui.control.QuietButton;

@EnabledIf(value = Displays.AVAILABLE, disabledReason = Displays.REASON)
class LogSwtTest {
  private final Theme theme = Themes.dark(TestDisplay.get());
  private final Shell shell = new Shell(TestDisplay.get(), SWT.NO_TRIM);
  private final FakeUicContext context = new FakeUicContext("log", new LogType().schema());
  private LogUic uic;
  private String note = "";

  @BeforeEach
  void open() {
    shell.setLayout(new FillLayout());
    shell.setSize(900, 500);
    uic = new LogUic(context);
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
  void theNewestIsFollowedUntilAnOlderEntryIsChosenAndThePillLeadsBack() {
    say(100);
    assertTrue(atEnd());
    assertFalse(pill().getVisible());
    press(list(), 300, 30);
    assertTrue(pill().getVisible());
    int before = list().getVerticalBar().getSelection();
    say(7);
    assertEquals(before, list().getVerticalBar().getSelection(), "what is read stays in place");
    pill().press();
    assertTrue(atEnd());
    assertFalse(pill().getVisible());
  }

  @Test
  void theChosenEntryIsShownWhole() {
    context.input(LogType.LOG).put(new LogEntry(Severity.ERROR, "/node", "first\nsecond\nthird", "a.cpp:3"));
    tick();
    press(list(), 300, 10);
    Text body = all(shell).filter(Text.class::isInstance).map(Text.class::cast)
        .filter(t -> (t.getStyle() & SWT.MULTI) != 0).findFirst().orElseThrow();
    assertEquals("first\nsecond\nthird", body.getText());
    assertTrue(body.getParent().getSize().y > 0);
    Event escape = new Event();
    escape.keyCode = SWT.ESC;
    list().notifyListeners(SWT.KeyDown, escape);
    assertEquals(0, body.getParent().getSize().y);
  }

  @Test
  void aPauseHoldsTheListAndTheTitleGoesOnCounting() {
    say(10);
    uic.actions().getFirst().run().run();
    tick();
    say(5);
    assertTrue(pill().getVisible());
    assertTrue(note.startsWith("10 of 15"), note);
    pill().press();
    tick();
    assertTrue(note.startsWith("15"), note);
  }

  @Test
  void howeverManyEntriesComeBetweenTwoPaintsTheyAreOnePaint() {
    say(50);
    spin();
    long before = ((PaintedCanvas) (Control) list()).paints();
    for (int i = 0; i < 20; i++) {
      say(250);
    }
    spin();
    assertTrue(((PaintedCanvas) (Control) list()).paints() - before <= 2, "5000 entries are painted at once");
  }

  @Test
  void aViewThatIsGoneBearsARefresh() {
    shell.dispose();
    say(3);
  }

  private void say(int count) {
    for (int i = 0; i < count; i++) {
      context.input(LogType.LOG).put(new LogEntry(Severity.INFO, "/node", "message " + i, ""));
    }
    tick();
  }

  private void tick() {
    uic.tick(System.nanoTime());
    uic.refresh();
  }

  private void spin() {
    while (shell.getDisplay().readAndDispatch()) {
      continue;
    }
  }

  private boolean atEnd() {
    int selection = list().getVerticalBar().getSelection();
    return selection > 0 && selection + list().getClientArea().height >= list().getVerticalBar().getMaximum();
  }

  private QuietButton pill() {
    return Stream.of(list().getParent().getChildren()).filter(QuietButton.class::isInstance)
        .map(QuietButton.class::cast).findFirst().orElseThrow();
  }

  /** The list is the one beside the pill. */
  private Scrollable list() {
    return all(shell).filter(PaintedCanvas.class::isInstance).map(Scrollable.class::cast)
        .filter(c -> c.getVerticalBar() != null)
        .filter(c -> List.of(c.getParent().getChildren()).stream().anyMatch(QuietButton.class::isInstance)).findFirst()
        .orElseThrow();
  }

  private static Stream<Control> all(Control control) {
    return control instanceof Composite composite
        ? Stream.concat(Stream.of(control), Stream.of(composite.getChildren()).flatMap(LogSwtTest::all))
        : Stream.of(control);
  }

  private static void press(Control control, int x, int y) {
    Event down = new Event();
    down.button = 1;
    down.x = x;
    down.y = y;
    control.notifyListeners(SWT.MouseDown, down);
  }
}
