package org.robotui.workbench.internal.pane;

import java.util.List;
import java.util.Optional;
import java.util.stream.Stream;
import org.eclipse.swt.SWT;
import org.eclipse.swt.graphics.GC;
import org.eclipse.swt.graphics.Rectangle;
import org.eclipse.swt.layout.GridLayout;
import org.eclipse.swt.widgets.Composite;
import org.eclipse.swt.widgets.Control;
import org.eclipse.swt.widgets.Event;
import org.eclipse.swt.widgets.Listener;
import org.eclipse.swt.widgets.Shell;
import org.eclipse.swt.widgets.Text;
import org.robotui.ui.Face;
import org.robotui.ui.Health;
import org.robotui.ui.Role;
import org.robotui.ui.Theme;
import org.robotui.ui.control.Boxes;
import org.robotui.ui.control.FilterField;
import org.robotui.ui.control.RowList;
import org.robotui.ui.control.RowLook;
import org.robotui.ui.control.RowWords;
import org.robotui.workbench.internal.model.SearchEntry;
import org.robotui.workbench.internal.model.SearchIndex;

/**
 * The search for commands, views, their actions and robots, above the views. It is a part of the window and not a
 * window of its own: the focus moves within a window at once, so no key that is typed after the one that opens it goes
 * elsewhere. Display thread only.
 */
public final class SearchPane extends Composite {
  private static final int WIDTH = 640;
  private static final int HEIGHT = 420;
  private static final int LEAST_HEIGHT = 120;
  private static final int HEAD = 26 + 3 * Theme.STEP + 6;
  private static final int TOP = 5;

  private final SearchIndex all;
  private final FilterField field;
  private final RowList<SearchEntry> list;
  private final Optional<Control> former;
  private final Listener pressed = this::pressedElsewhere;

  private SearchPane(Shell shell, Theme theme, String hint, List<SearchEntry> all) {
    super(shell, SWT.NONE);
    this.all = new SearchIndex(all);
    former = Optional.ofNullable(shell.getDisplay().getFocusControl());
    setBackground(theme.color(Role.LINE));
    GridLayout frame = Boxes.grid(1);
    frame.marginWidth = 1;
    frame.marginHeight = 1;
    setLayout(frame);
    Composite body = Boxes.inset(this, theme, 1, Theme.STEP, Theme.STEP);
    body.setLayoutData(Boxes.fill());
    field = new FilterField(body, theme, hint, this::find);
    field.setLayoutData(Boxes.line());
    list = new RowList<>(body, theme, new Look(theme)).named("Found").onOpen(this::run);
    list.control().setLayoutData(Boxes.fill());
    list.control().addListener(SWT.MouseUp, e -> choose());
    listen();
    find("");
  }

  /** Opens it in a window, or has the one that is open there take the keys again. */
  public static SearchPane open(Shell shell, Theme theme, List<SearchEntry> all) {
    return in(shell)
        .orElseGet(() -> new SearchPane(shell, theme, "Search commands, views, robots, topics, settings", all)).take();
  }

  /** Opens the list of shortcuts in a window, in place of a search that is open there. */
  public static SearchPane openShortcuts(Shell shell, Theme theme, List<SearchEntry> all) {
    return openList(shell, theme, "Search keyboard shortcuts", all);
  }

  /** Opens a list in a window, in place of a search that is open there. */
  public static SearchPane openList(Shell shell, Theme theme, String hint, List<SearchEntry> all) {
    in(shell).ifPresent(SearchPane::close);
    return new SearchPane(shell, theme, hint, all).take();
  }

  private SearchPane take() {
    place();
    moveAbove(null);
    layout(true, true);
    field.focus();
    return this;
  }

  /** The one that is open in a window. */
  public static Optional<SearchPane> in(Shell shell) {
    return Stream.of(shell.getChildren()).filter(SearchPane.class::isInstance).map(SearchPane.class::cast).findFirst();
  }

  /** The one that a control belongs to. */
  public static Optional<SearchPane> around(Control inside) {
    Control at = inside;
    while (at != null && !(at instanceof SearchPane)) {
      at = at.getParent();
    }
    return Optional.ofNullable((SearchPane) at);
  }

  /** What is found now, the nearest first. */
  List<SearchEntry> found() {
    return list.rows();
  }

  private void listen() {
    Text text =
        Stream.of(field.getChildren()).filter(Text.class::isInstance).map(Text.class::cast).findFirst().orElseThrow();
    text.addListener(SWT.KeyDown, this::key);
    text.addListener(SWT.FocusOut, e -> getDisplay().asyncExec(this::left));
    list.control().addListener(SWT.KeyDown, this::key);
    field.onEnter(this::choose);
    getDisplay().addFilter(SWT.MouseDown, pressed);
    addListener(SWT.Dispose, e -> getDisplay().removeFilter(SWT.MouseDown, pressed));
    Listener resized = e -> place();
    getShell().addListener(SWT.Resize, resized);
    addListener(SWT.Dispose, e -> getShell().removeListener(SWT.Resize, resized));
  }

  private void place() {
    Rectangle window = getShell().getClientArea();
    int width = Math.min(WIDTH, window.width);
    int height = Math.clamp(list.rows().size() * (long) RowLook.HEIGHT + HEAD, LEAST_HEIGHT, HEIGHT);
    setBounds((window.width - width) / 2, TOP, width, Math.min(height, window.height - TOP));
  }

  private void find(String words) {
    list.show(all.find(words));
    list.rows().stream().findFirst().ifPresentOrElse(first -> {
      list.noMessage();
      list.select(first);
    }, () -> list.message(Health.NONE, "No match",
        "Search by words or a few letters of a command, a view, a robot or a topic."));
    place();
  }

  private void key(Event event) {
    switch (event.keyCode) {
      case SWT.ESC -> close();
      case SWT.ARROW_DOWN -> move(event, 1);
      case SWT.ARROW_UP -> move(event, -1);
      default -> {}
    }
  }

  /** The text keeps the keys. */
  private void move(Event event, int by) {
    event.doit = false;
    int at = list.selected().stream().findFirst().map(list.rows()::indexOf).orElse(-1) + by;
    if (at >= 0 && at < list.rows().size()) {
      list.select(list.rows().get(at));
    }
  }

  private void choose() {
    list.selected().stream().findFirst().ifPresent(this::run);
  }

  /** Closed first: what is done may open something, and be meant for the view that had the focus. */
  private void run(SearchEntry entry) {
    close();
    entry.run().run();
  }

  private void close() {
    if (!isDisposed()) {
      former.filter(control -> !control.isDisposed()).ifPresent(Control::setFocus);
      dispose();
    }
  }

  private void left() {
    if (!isDisposed() && getDisplay().getFocusControl() instanceof Control now && !isWithin(now)) {
      dispose();
    }
  }

  private void pressedElsewhere(Event event) {
    if (event.widget instanceof Control control && !isWithin(control)) {
      dispose();
    }
  }

  private boolean isWithin(Control control) {
    return around(control).filter(pane -> pane == this).isPresent();
  }

  /** What it does at the left, then where it belongs, and its keys at the right. */
  private static final class Look implements RowLook<SearchEntry> {
    private static final int GROUP = 110;
    private static final int KEYS = 150;

    private final RowWords words;

    Look(Theme theme) {
      words = new RowWords(theme);
    }

    @Override
    public Object key(SearchEntry row) {
      return row;
    }

    @Override
    public String text(SearchEntry row) {
      return row.label() + "\t" + row.group() + "\t" + row.keys();
    }

    @Override
    public void paint(GC gc, Rectangle at, SearchEntry row) {
      int left = 3 * Theme.STEP;
      words.text(gc, at, left, GROUP - Theme.STEP, row.group(), Face.SMALL, Role.DIM);
      words.text(gc, at, left + GROUP, at.width - GROUP - KEYS - 2 * left, row.label(), Face.BODY, Role.TEXT);
      words.right(gc, at, at.width - KEYS - left, KEYS, row.keys(), Role.DIM);
    }
  }
}
