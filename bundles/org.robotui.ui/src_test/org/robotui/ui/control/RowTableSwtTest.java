package org.robotui.ui.control;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import java.util.Optional;
import java.util.stream.IntStream;
import org.eclipse.swt.SWT;
import org.eclipse.swt.dnd.Clipboard;
import org.eclipse.swt.dnd.TextTransfer;
import org.eclipse.swt.graphics.Rectangle;
import org.eclipse.swt.layout.FillLayout;
import org.eclipse.swt.widgets.Composite;
import org.eclipse.swt.widgets.Control;
import org.eclipse.swt.widgets.Display;
import org.eclipse.swt.widgets.Event;
import org.eclipse.swt.widgets.Shell;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.condition.EnabledIf;
import org.robotui.testkit.Displays;
import org.robotui.testkit.TestDisplay;
import org.robotui.ui.PaintedCanvas;
import org.robotui.ui.Theme;
import org.robotui.ui.Themes;

@EnabledIf(value = Displays.AVAILABLE, disabledReason = Displays.REASON)
class RowTableSwtTest {
  private static final int ROWS = 100_000;
  private static final long PATIENCE_NANOS = 30_000_000_000L;

  private final Display display = TestDisplay.get();
  private final List<Integer> formatted = new ArrayList<>();
  private final List<Boolean> followed = new ArrayList<>();
  private Theme theme;
  private Shell shell;
  private RowTable<Integer> table;

  @BeforeEach
  void open() {
    theme = Themes.dark(display);
    shell = new Shell(display);
    shell.setLayout(new FillLayout());
    Column<Integer> number =
        Column.<Integer>figures("Number", this::format).width(100).order(Comparator.naturalOrder());
    table = new RowTable<>(shell, theme, List.of(number, Column.words("Name", i -> "row " + i)), i -> i);
    shell.setSize(400, 300);
    shell.open();
    settle();
  }

  @AfterEach
  void close() {
    shell.dispose();
    theme.dispose();
  }

  @Test
  void onlyWhatIsSeenIsFormatted() {
    show(numbers(0, ROWS));
    assertTrue(formatted.contains(0), "the first row is seen");
    assertTrue(formatted.stream().allMatch(i -> i < 20), "rows beyond the window were formatted: " + formatted.size());
  }

  @Test
  void aTextIsSaidInFewerWordsOnlyWhereItDoesNotFit() {
    Column<String> type = Column.<String>words("Type", s -> s).brief(s -> s.substring(s.lastIndexOf('/') + 1));
    assertEquals("a/b", type.fitting("a/b", text -> true));
    assertEquals("b", type.fitting("a/b", text -> false));
    assertEquals("a b", Column.<String>words("Type", s -> s).fitting("a\nb", text -> false),
        "without shorter words it is cut");
  }

  @Test
  void theEndOfManyRowsIsReachedByAKeyAndSeen() {
    show(numbers(0, ROWS));
    press(SWT.END, 0);
    assertEquals(List.of(ROWS - 1), table.list().selected());
    formatted.clear();
    settle();
    assertTrue(formatted.contains(ROWS - 1));
  }

  @Test
  void aListSaysWhatIsSeenAndWhereARowLies() {
    assertEquals(List.of(), table.list().visible(5));
    show(numbers(0, ROWS));
    press(SWT.END, 0);
    List<Integer> seen = table.list().visible();
    assertEquals(ROWS - 1, seen.getLast());
    assertEquals(seen, table.list().visible(7), "there is nothing below the end");
    Rectangle last = table.list().bounds(ROWS - 1).orElseThrow();
    assertEquals(table.list().control().getSize().y, last.y + last.height);
    assertTrue(table.list().bounds(0).orElseThrow().y < 0, "out of sight, above");
    assertEquals(Optional.empty(), table.list().bounds(ROWS));
  }

  @Test
  void keysMoveTheSelection() {
    show(numbers(0, 50));
    press(SWT.ARROW_DOWN, 0);
    press(SWT.ARROW_DOWN, 0);
    assertEquals(List.of(1), table.list().selected());
    press(SWT.ARROW_UP, 0);
    press(SWT.ARROW_UP, 0);
    assertEquals(List.of(0), table.list().selected());
    press(SWT.PAGE_DOWN, 0);
    assertTrue(table.list().selected().getFirst() > 4);
  }

  @Test
  void severalRowsAreCopiedAsTabSeparatedText() {
    table.list().several();
    show(numbers(0, 50));
    click(0, 0);
    click(2, SWT.SHIFT);
    click(4, SWT.MOD1);
    press('c', SWT.MOD1);
    Clipboard clipboard = new Clipboard(display);
    Object copied = clipboard.getContents(TextTransfer.getInstance());
    clipboard.dispose();
    assertEquals("0\trow 0\n1\trow 1\n2\trow 2\n4\trow 4", copied);
  }

  @Test
  void withoutSeveralModifiersSelectOne() {
    show(numbers(0, 50));
    click(0, 0);
    click(2, SWT.SHIFT);
    assertEquals(List.of(2), table.list().selected());
  }

  @Test
  void enterAndDoubleClickOpen() {
    List<Integer> opened = new ArrayList<>();
    table.list().onOpen(opened::add);
    show(numbers(0, 50));
    click(3, 0);
    press(SWT.CR, 0);
    click(5, 0);
    send(table.list().control(), SWT.MouseDoubleClick, 1, 5, 5 * RowLook.HEIGHT + 3, 0, 0);
    assertEquals(List.of(3, 5), opened);
  }

  @Test
  void theNewestStaysInSightUntilTheUserGoesUp() {
    table.list().follow(followed::add);
    show(numbers(0, 1000));
    show(numbers(0, 2000));
    assertTrue(sees(1999));
    press(SWT.ARROW_UP, 0);
    press(SWT.HOME, 0);
    show(numbers(0, 3000));
    assertFalse(table.list().following());
    assertTrue(sees(0));
    press(SWT.END, 0);
    assertEquals(List.of(false, true), followed);
    show(numbers(0, 4000));
    assertTrue(sees(3999));
  }

  @Test
  void whatIsReadStaysInPlaceWhileOldRowsGo() {
    table.list().follow(followed::add);
    show(numbers(0, 1000));
    table.list().following(false);
    table.list().select(500);
    settle();
    assertTrue(sees(500));
    show(numbers(200, 1200));
    assertTrue(sees(500));
  }

  @Test
  void aClickOnAHeadingAsksForAnotherOrder() {
    List<String> asked = new ArrayList<>();
    table.onOrder(() -> asked.add("again"));
    Control header = ((Composite) table.control()).getChildren()[0];
    send(header, SWT.MouseDown, 1, 20, 5, 0, 0);
    send(header, SWT.MouseUp, 1, 20, 5, 0, 0);
    send(header, SWT.MouseDown, 1, 20, 5, 0, 0);
    send(header, SWT.MouseUp, 1, 20, 5, 0, 0);
    assertEquals(2, asked.size());
    assertEquals(List.of(3, 2, 1), table.sorted(List.of(1, 3, 2)));
  }

  @Test
  void aHeadingWithoutAnOrderDoesNothing() {
    Control header = ((Composite) table.control()).getChildren()[0];
    send(header, SWT.MouseDown, 1, 250, 5, 0, 0);
    send(header, SWT.MouseUp, 1, 250, 5, 0, 0);
    assertTrue(table.order().isEmpty());
  }

  @Test
  void aTableOfManyRowsIsShownAndPaintedQuickly() {
    show(numbers(0, ROWS));
    List<List<Integer>> updates = IntStream.range(0, 30).mapToObj(i -> numbers(i, ROWS)).toList();
    long start = System.nanoTime();
    updates.forEach(this::show);
    double millis = (System.nanoTime() - start) / 1e6 / updates.size();
    assertTrue(millis < 250, millis + " ms for an update");
  }

  private boolean sees(int number) {
    formatted.clear();
    table.list().redraw();
    settle();
    return formatted.contains(number);
  }

  private String format(int number) {
    formatted.add(number);
    return Integer.toString(number);
  }

  private static List<Integer> numbers(int from, int to) {
    return IntStream.range(from, to).boxed().toList();
  }

  private void show(List<Integer> rows) {
    table.show(rows);
    settle();
  }

  private void settle() {
    PaintedCanvas canvas = table.list().canvas();
    long painted = canvas.paints();
    canvas.redraw();
    long end = System.nanoTime() + PATIENCE_NANOS;
    while (canvas.paints() == painted && System.nanoTime() < end) {
      if (!display.readAndDispatch()) {
        Thread.onSpinWait();
      }
    }
    assertTrue(canvas.paints() > painted, "the table was not painted");
  }

  private void press(int keyCode, int stateMask) {
    send(table.list().control(), SWT.KeyDown, 0, 0, 0, keyCode, stateMask);
  }

  private void click(int row, int stateMask) {
    int y = row * RowLook.HEIGHT + 3;
    send(table.list().control(), SWT.MouseDown, 1, 5, y, 0, stateMask);
    send(table.list().control(), SWT.MouseUp, 1, 5, y, 0, stateMask);
  }

  private static void send(Control control, int type, int button, int x, int y, int keyCode, int stateMask) {
    Event event = new Event();
    event.button = button;
    event.x = x;
    event.y = y;
    event.keyCode = keyCode;
    event.stateMask = stateMask;
    control.notifyListeners(type, event);
  }
}
