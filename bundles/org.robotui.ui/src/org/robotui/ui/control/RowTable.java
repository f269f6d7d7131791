package org.robotui.ui.control;

import java.util.List;
import java.util.Optional;
import java.util.function.Function;
import java.util.stream.Collectors;
import java.util.stream.IntStream;
import org.eclipse.swt.SWT;
import org.eclipse.swt.graphics.GC;
import org.eclipse.swt.graphics.Rectangle;
import org.eclipse.swt.layout.GridData;
import org.eclipse.swt.layout.GridLayout;
import org.eclipse.swt.widgets.Composite;
import org.eclipse.swt.widgets.Control;
import org.eclipse.swt.widgets.Event;
import org.robotui.ui.Role;
import org.robotui.ui.Theme;

/**
 * A table: headings, and a {@link RowList} of rows in columns. Made for a hundred thousand rows that change at the rate
 * of the view: the tick prepares an immutable list, sorted by {@link #sorted}, and the display thread only paints what
 * is seen. A click on a heading, or Ctrl with the digit of its place, sorts. All on the display thread, but for
 * {@link #sorted} and {@link #order}.
 *
 * @param <R> a row, immutable
 */
public final class RowTable<R> {
  private static final double LINE_SHARE = 0.55;

  private final Composite root;
  private final Theme theme;
  private final List<Column<R>> columns;
  private final ColumnWidths widths;
  private final TableHeader<R> header;
  private final RowList<R> list;
  private final CellPainter cells;
  private final Function<R, Object> key;
  private volatile Optional<RowOrder<R>> order = Optional.empty();
  private Runnable ordered = () -> {};
  private int[] edges = {0};

  /**
   * An empty table.
   *
   * @param parent the parent
   * @param theme colours and fonts
   * @param columns from left to right
   * @param key what identifies a row, unique in the table
   */
  public RowTable(Composite parent, Theme theme, List<Column<R>> columns, Function<R, Object> key) {
    this.theme = theme;
    this.columns = List.copyOf(columns);
    this.key = key;
    widths = new ColumnWidths(this.columns);
    cells = new CellPainter(theme);
    root = new Composite(parent, SWT.NONE);
    root.setBackground(theme.color(Role.PANEL));
    root.setLayout(layout());
    header = new TableHeader<>(root, theme, this.columns, widths, this::resized, this::clicked);
    GridData top = new GridData(SWT.FILL, SWT.TOP, true, false);
    top.heightHint = TableHeader.HEIGHT;
    header.canvas().setLayoutData(top);
    list = new RowList<>(root, theme, new Look());
    list.control().setLayoutData(new GridData(SWT.FILL, SWT.FILL, true, true));
    list.control().addListener(SWT.Resize, e -> resized());
    list.control().addListener(SWT.KeyDown, this::key);
  }

  /**
   * What stands in the layout.
   *
   * @return the control
   */
  public Control control() {
    return root;
  }

  /**
   * The list below the headings: selection, opening, menu, dragging, following, messages, and the state of the input
   * are set there.
   *
   * @return the list
   */
  public RowList<R> list() {
    return list;
  }

  /**
   * Shows rows as they are, see {@link RowList#show}.
   *
   * @param rows immutable, sorted as {@link #sorted} does
   */
  public void show(List<R> rows) {
    list.show(rows);
  }

  /**
   * Sorts by a column at first.
   *
   * @param first the order
   * @return this
   */
  public RowTable<R> order(RowOrder<R> first) {
    order = Optional.of(first);
    header.order(order);
    return this;
  }

  /**
   * The order that the user chose. Any thread.
   *
   * @return the order, none before the first choice
   */
  public Optional<RowOrder<R>> order() {
    return order;
  }

  /**
   * Sorts rows as the user chose. Any thread; for a view's tick.
   *
   * @param rows in their usual order
   * @return the rows to show, immutable
   */
  public List<R> sorted(List<R> rows) {
    return order.map(o -> o.sort(rows)).orElseGet(() -> List.copyOf(rows));
  }

  /**
   * Tells when the user chose another order, to have the view's tick sort soon.
   *
   * @param action runs on the display thread
   * @return this
   */
  public RowTable<R> onOrder(Runnable action) {
    ordered = action;
    return this;
  }

  /**
   * The column at a place, for example where a drag begins.
   *
   * @param x in the coordinates of the control of {@link #list}
   * @return the column, or none beside all columns
   */
  public Optional<Column<R>> columnAt(int x) {
    return IntStream.range(0, edges.length - 1).filter(i -> x >= edges[i] && x < edges[i + 1]).mapToObj(columns::get)
        .findFirst();
  }

  /**
   * Marks words in the cells.
   *
   * @param words what was searched, empty for nothing
   */
  public void highlight(String words) {
    cells.search(words);
    list.redraw();
  }

  /** Headings have no focus of their own: Ctrl with a digit sorts by the column that stands there. */
  private void key(Event event) {
    int digit = event.keyCode - '1';
    if ((event.stateMask & SWT.MOD1) != 0 && digit >= 0 && digit < '9' - '0') {
      IntStream.range(0, edges.length - 1).filter(i -> edges[i + 1] > edges[i]).skip(digit).mapToObj(columns::get)
          .findFirst()
          .filter(column -> column.order().isPresent()).ifPresent(this::clicked);
    }
  }

  private void clicked(Column<R> column) {
    order(order.map(o -> o.clicked(column)).orElseGet(() -> new RowOrder<>(column, false)));
    ordered.run();
  }

  private void resized() {
    edges = widths.edges(list.control().getSize().x == 0 ? 0 : list.canvas().getClientArea().width);
    header.edges(edges);
    list.redraw();
  }

  private static GridLayout layout() {
    GridLayout layout = new GridLayout(1, false);
    layout.marginWidth = 0;
    layout.marginHeight = 0;
    layout.verticalSpacing = 0;
    return layout;
  }

  /** Rows in columns. */
  private final class Look implements RowLook<R> {
    @Override
    public Object key(R row) {
      return key.apply(row);
    }

    @Override
    public String text(R row) {
      return columns.stream().map(column -> CellPainter.line(column.text(row))).collect(Collectors.joining("\t"));
    }

    @Override
    public void paint(GC gc, Rectangle at, R row) {
      gc.setForeground(theme.mix(Role.LINE, Role.PANEL, LINE_SHARE));
      gc.setLineWidth(1);
      gc.drawLine(at.x + CellPainter.PADDING, at.y + at.height - 1, at.x + at.width - CellPainter.PADDING,
          at.y + at.height - 1);
      for (int i = 0; i + 1 < edges.length; i++) {
        if (edges[i + 1] > edges[i]) {
          cells.cell(gc, cell(at, i), columns.get(i), row);
        }
      }
    }

    @Override
    public String hint(GC gc, Rectangle at, R row, int x) {
      for (int i = 0; i + 1 < edges.length; i++) {
        if (x >= edges[i] && x < edges[i + 1]) {
          Column<R> column = columns.get(i);
          String own = column.hint(row);
          return own.isEmpty() && cells.isCut(gc, cell(at, i), column, row) ? column.text(row) : own;
        }
      }
      return "";
    }

    private Rectangle cell(Rectangle at, int column) {
      return new Rectangle(at.x + edges[column], at.y, edges[column + 1] - edges[column], at.height);
    }
  }
}
