package org.robotui.ui.control;

import java.util.Collection;
import java.util.List;
import java.util.Optional;
import java.util.function.BiConsumer;
import java.util.function.Consumer;
import java.util.function.Function;
import java.util.stream.Collectors;
import java.util.stream.IntStream;
import org.eclipse.swt.SWT;
import org.eclipse.swt.graphics.Rectangle;
import org.eclipse.swt.widgets.Composite;
import org.eclipse.swt.widgets.Control;
import org.robotui.api.port.InputState;
import org.robotui.ui.Health;
import org.robotui.ui.PaintedCanvas;
import org.robotui.ui.Role;
import org.robotui.ui.Theme;
import org.robotui.ui.ViewAction;

/**
 * A scrolled list of rows of equal height, of which only what is seen is painted: showing a hundred thousand rows costs
 * no more than showing ten. Rows are selected by key, so that they stay selected while others come and go. Arrow keys,
 * page keys, Home and End move, Enter and a double-click open, Ctrl+C copies, Ctrl+F or / finds. Display thread only.
 *
 * @param <R> a row, immutable
 */
public final class RowList<R> {
  private final PaintedCanvas canvas;
  private final RowLook<R> look;
  private final RowPaint<R> paint;
  private final RowScroll scroll;
  private final RowMarks<R> marks;
  private final RowInput<R> input;
  private final RowFollow followed = new RowFollow();
  private List<R> rows = List.of();
  private Consumer<List<R>> selected = rows -> {};

  /**
   * An empty list.
   *
   * @param parent the parent
   * @param theme colours and fonts
   * @param look how rows look
   */
  public RowList(Composite parent, Theme theme, RowLook<R> look) {
    this.look = look;
    paint = new RowPaint<>(this, theme);
    marks = new RowMarks<>(look::key);
    canvas = new PaintedCanvas(parent, SWT.V_SCROLL, theme, Role.PANEL, paint::paint);
    scroll = new RowScroll(canvas, look.height(), this::scrolled);
    input = new RowInput<>(this);
    canvas.addListener(SWT.Resize, e -> resized());
    canvas.addListener(SWT.FocusIn, e -> canvas.redraw());
    canvas.addListener(SWT.FocusOut, e -> canvas.redraw());
    input.listen(canvas);
  }

  /**
   * What stands in the layout.
   *
   * @return the control
   */
  public Control control() {
    return canvas;
  }

  /**
   * Names it for screen readers.
   *
   * @param name what it lists
   * @return this
   */
  public RowList<R> named(String name) {
    Spoken.list(canvas, name, () -> leading().map(look::text).orElse(""));
    return this;
  }

  /**
   * Lets several rows be selected, with Shift, Ctrl and Ctrl+A.
   *
   * @return this
   */
  public RowList<R> several() {
    input.several();
    return this;
  }

  /**
   * Keeps the newest, last row in sight until the user scrolls up or selects another row, and again from when the user
   * goes back to the end. What is seen meanwhile stays in place when rows go at the beginning.
   *
   * @param changed is told when following begins or ends; now it does follow
   * @return this
   */
  public RowList<R> follow(Consumer<Boolean> changed) {
    followed.begin(changed);
    return this;
  }

  /**
   * Begins or ends following.
   *
   * @param on whether the end stays in sight
   */
  public void following(boolean on) {
    if (followed.set(on) && on) {
      scroll.toEnd();
      canvas.redraw();
    }
  }

  /**
   * Whether the end stays in sight.
   *
   * @return false where {@link #follow} was not asked for
   */
  public boolean following() {
    return followed.now();
  }

  /**
   * Tells when the selection changes.
   *
   * @param action is given the selected rows
   * @return this
   */
  public RowList<R> onSelect(Consumer<List<R>> action) {
    selected = action;
    return this;
  }

  /**
   * Tells when a row is opened, by Enter or a double-click.
   *
   * @param action is given the row
   * @return this
   */
  public RowList<R> onOpen(Consumer<R> action) {
    input.open = action;
    return this;
  }

  /**
   * What the search keys do.
   *
   * @param action for example focus of a {@link FilterField}
   * @return this
   */
  public RowList<R> onFind(Runnable action) {
    input.find = action;
    return this;
  }

  /**
   * Gives the rows a context menu.
   *
   * @param actions is asked for the actions on the selected rows
   * @return this
   */
  public RowList<R> menu(Function<List<R>, List<ViewAction>> actions) {
    canvas.addListener(SWT.MenuDetect, e -> RowExport.menu(canvas, e.x, e.y, actions.apply(selected())));
    return this;
  }

  /**
   * Gives the rows a context menu with menus within it.
   *
   * @param fill is given the menu and the selected rows; what it leaves empty is not opened
   * @return this
   */
  public RowList<R> menu(BiConsumer<PopupMenu, List<R>> fill) {
    canvas.addListener(SWT.MenuDetect, e -> RowExport.menu(canvas, e.x, e.y, menu -> fill.accept(menu, selected())));
    return this;
  }

  /**
   * Lets rows be dragged as text, for example a topic into a plot.
   *
   * @param text is asked for the text of a row, none where it cannot be dragged
   * @return this
   */
  public RowList<R> drag(Function<R, Optional<String>> text) {
    RowExport.drag(canvas, y -> dragged(y, text));
    return this;
  }

  /**
   * Shows rows. Costs the same for any number.
   *
   * @param next the rows, immutable, as the view's tick prepared them
   */
  public void show(List<R> next) {
    if (next == rows) {
      return;
    }
    List<R> before = rows;
    rows = next;
    marks.rows(next);
    int kept = followed.paused() ? Anchor.find(before, next, scroll.first(), look::key) : -1;
    int within = scroll.offset() - scroll.first() * look.height();
    scroll.rows(next.size());
    if (followed.now()) {
      scroll.toEnd();
    } else if (kept >= 0) {
      scroll.offset(kept * look.height() + within);
    }
    canvas.redraw();
  }

  /**
   * Shows the state of the input that the rows come from: rows are faded while it is stale, and a message is in their
   * place while there is no data.
   *
   * @param next the state
   */
  public void state(InputState next) {
    redrawIf(paint.state(next));
  }

  /**
   * Shows a message in place of rows.
   *
   * @param health its dot
   * @param title a few words
   * @param sentence what is so and what would help
   */
  public void message(Health health, String title, String sentence) {
    redrawIf(paint.message(Optional.of(new RowPaint.Message(health, title, sentence))));
  }

  /** Shows rows again. */
  public void noMessage() {
    redrawIf(paint.message(Optional.empty()));
  }

  /**
   * The rows shown.
   *
   * @return the rows, in order
   */
  public List<R> rows() {
    return rows;
  }

  /**
   * The rows that are seen now, also where only a part of them is.
   *
   * @return from the uppermost to the lowest, a part of {@link #rows()}
   */
  public List<R> visible() {
    return visible(0);
  }

  /**
   * The rows that are seen now, and some that would be seen next.
   *
   * @param ahead how many below those that are seen
   * @return from the uppermost on, a part of {@link #rows()}
   */
  public List<R> visible(int ahead) {
    int first = Math.min(scroll.first(), rows.size());
    return rows.subList(first, Math.clamp((long) scroll.end() + ahead, first, rows.size()));
  }

  /**
   * Where a row lies, also where that is out of sight.
   *
   * @param key of the row
   * @return its place in the control, or empty where it is not among the rows
   */
  public Optional<Rectangle> bounds(Object key) {
    return IntStream.range(0, rows.size()).filter(i -> look.key(rows.get(i)).equals(key)).mapToObj(this::at)
        .findFirst();
  }

  /**
   * The selected rows that are shown.
   *
   * @return the rows, in the order shown
   */
  public List<R> selected() {
    return marks.selected();
  }

  /**
   * Selects a row, also one that is not shown yet; nobody is told.
   *
   * @param key its key
   */
  public void select(Object key) {
    marks.key(key);
    int index = marks.leadIndex();
    if (index >= 0) {
      scroll.reveal(index);
    }
    canvas.redraw();
  }

  /**
   * Selects several rows, also such that are not shown yet, and no others; nobody is told.
   *
   * @param keys their keys
   */
  public void selectAll(Collection<?> keys) {
    marks.keys(keys);
    canvas.redraw();
  }

  /** Selects nothing; nobody is told. */
  public void selectNone() {
    redrawIf(marks.clear());
  }

  /** Paints again, where the look of rows changed but not the rows. */
  public void redraw() {
    canvas.redraw();
  }

  PaintedCanvas canvas() {
    return canvas;
  }

  RowScroll scroll() {
    return scroll;
  }

  RowMarks<R> marks() {
    return marks;
  }

  RowLook<R> look() {
    return look;
  }

  RowInput<R> input() {
    return input;
  }

  Optional<R> leading() {
    int index = marks.leadIndex();
    return index >= 0 ? Optional.of(rows.get(index)) : Optional.empty();
  }

  /** The place of a row in the canvas. */
  Rectangle at(int index) {
    return new Rectangle(0, scroll.top(index), canvas.getClientArea().width, look.height());
  }

  /** After the user chose; the row may be none. */
  void chose(int index) {
    if (index >= 0) {
      scroll.reveal(index);
      followed.set(index == rows.size() - 1 && scroll.atEnd());
    }
    canvas.redraw();
    Spoken.changed(canvas);
    selected.accept(selected());
  }

  void hover(int index) {
    redrawIf(paint.hover(index));
  }

  /** Copies what is selected. */
  void copy() {
    Clipboards.copy(selected().stream().map(look::text).collect(Collectors.joining("\n")));
  }

  private Optional<String> dragged(int y, Function<R, Optional<String>> text) {
    int index = scroll.indexAt(y);
    if (index < 0) {
      return Optional.empty();
    }
    R row = rows.get(index);
    List<R> taken = marks.has(row) ? selected() : List.of(row);
    return Optional.of(taken.stream().map(text).flatMap(Optional::stream).collect(Collectors.joining("\n")));
  }

  private void scrolled() {
    followed.set(scroll.atEnd());
    canvas.redraw();
  }

  private void redrawIf(boolean changed) {
    if (changed) {
      canvas.redraw();
    }
  }

  private void resized() {
    scroll.fit();
    if (followed.now()) {
      scroll.toEnd();
    }
  }
}
