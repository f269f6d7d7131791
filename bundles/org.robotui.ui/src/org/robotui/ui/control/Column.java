package org.robotui.ui.control;

import java.util.Comparator;
import java.util.Optional;
import java.util.function.Function;
import java.util.function.Predicate;
import java.util.function.UnaryOperator;
import org.eclipse.swt.graphics.GC;
import org.eclipse.swt.graphics.Rectangle;
import org.robotui.ui.Face;
import org.robotui.ui.Health;
import org.robotui.ui.Role;

/**
 * A column of a {@link RowTable}: what it shows of a row, and how wide it is. Immutable; its functions are called on
 * the display thread for rows that are seen, and the order by whoever sorts.
 *
 * @param <R> a row
 */
public final class Column<R> {
  /**
   * Paints a cell in place of its words.
   *
   * @param <R> a row
   */
  @FunctionalInterface
  public interface CellPaint<R> {
    /**
     * Paints. Display thread.
     *
     * @param gc where; hover and selection are painted already
     * @param at the cell without its padding
     * @param row the row
     */
    void paint(GC gc, Rectangle at, R row);
  }

  private static final int USUAL_WIDTH = 80;

  private final String title;
  private final Function<R, String> text;
  private final Face face;
  private final boolean right;
  private Function<R, Role> role = row -> Role.TEXT;
  private Function<R, String> hint = row -> "";
  private Optional<Function<R, Health>> dot = Optional.empty();
  private Optional<Comparator<R>> order = Optional.empty();
  private Optional<CellPaint<R>> paint = Optional.empty();
  private double weight;
  private int width = USUAL_WIDTH;
  private int needed;
  private boolean highlighted = true;
  private UnaryOperator<String> brief = UnaryOperator.identity();

  private Column(String title, Function<R, String> text, Face face, boolean right) {
    this.title = title;
    this.text = text;
    this.face = face;
    this.right = right;
  }

  private Column(Column<R> other) {
    this(other.title, other.text, other.face, other.right);
    role = other.role;
    hint = other.hint;
    dot = other.dot;
    order = other.order;
    paint = other.paint;
    weight = other.weight;
    width = other.width;
    needed = other.needed;
    highlighted = other.highlighted;
    brief = other.brief;
  }

  /**
   * A column of words, at the left.
   *
   * @param title the heading
   * @param text the words of a row
   * @param <R> a row
   * @return the column, one part of what fixed widths leave
   */
  public static <R> Column<R> words(String title, Function<R, String> text) {
    return new Column<>(title, text, Face.BODY, false).weight(1);
  }

  /**
   * A column of figures of equal width, at the right.
   *
   * @param title the heading
   * @param text the figures of a row
   * @param <R> a row
   * @return the column, 80 points wide
   */
  public static <R> Column<R> figures(String title, Function<R, String> text) {
    return new Column<>(title, text, Face.FIGURES, true);
  }

  /**
   * A column of figures at the left, for values of any kind, times and hex.
   *
   * @param title the heading
   * @param text the figures of a row
   * @param <R> a row
   * @return the column, one part of what fixed widths leave
   */
  public static <R> Column<R> values(String title, Function<R, String> text) {
    return new Column<>(title, text, Face.FIGURES, false).weight(1);
  }

  /**
   * A column of a share of the room.
   *
   * @param share of what fixed widths leave, relative to other columns
   * @return a column like this
   */
  public Column<R> weight(double share) {
    Column<R> copy = new Column<>(this);
    copy.weight = share;
    return copy;
  }

  /**
   * A column of a fixed width.
   *
   * @param points the width
   * @return a column like this
   */
  public Column<R> width(int points) {
    Column<R> copy = new Column<>(this);
    copy.weight = 0;
    copy.width = points;
    return copy;
  }

  /**
   * A column that is left out where room is scarce.
   *
   * @param points the least width of the table with which it is shown
   * @return a column like this
   */
  public Column<R> from(int points) {
    Column<R> copy = new Column<>(this);
    copy.needed = points;
    return copy;
  }

  /**
   * A column in colours.
   *
   * @param color gives the colour of a row's words
   * @return a column like this
   */
  public Column<R> role(Function<R, Role> color) {
    Column<R> copy = new Column<>(this);
    copy.role = color;
    return copy;
  }

  /**
   * A column in one colour.
   *
   * @param color of all rows' words
   * @return a column like this
   */
  public Column<R> role(Role color) {
    return role(row -> color);
  }

  /**
   * A column with a dot before its words.
   *
   * @param health gives the dot of a row
   * @return a column like this
   */
  public Column<R> dot(Function<R, Health> health) {
    Column<R> copy = new Column<>(this);
    copy.dot = Optional.of(health);
    return copy;
  }

  /**
   * A column by which rows can be sorted.
   *
   * @param comparator the order, ascending
   * @return a column like this
   */
  public Column<R> order(Comparator<R> comparator) {
    Column<R> copy = new Column<>(this);
    copy.order = Optional.of(comparator);
    return copy;
  }

  /**
   * A column that paints its cells itself; its text remains for the clipboard, the tooltip and screen readers.
   *
   * @param painter paints a cell
   * @return a column like this
   */
  public Column<R> painted(CellPaint<R> painter) {
    Column<R> copy = new Column<>(this);
    copy.paint = Optional.of(painter);
    return copy;
  }

  /**
   * A column with a tooltip; without one, the tooltip is the text where it is cut.
   *
   * @param words gives the tooltip of a row's cell
   * @return a column like this
   */
  public Column<R> hint(Function<R, String> words) {
    Column<R> copy = new Column<>(this);
    copy.hint = words;
    return copy;
  }

  /**
   * A column that says the same in fewer words where the whole does not fit, before anything is cut.
   *
   * @param shorter makes the words that matter most of a text
   * @return a column like this
   */
  public Column<R> brief(UnaryOperator<String> shorter) {
    Column<R> copy = new Column<>(this);
    copy.brief = shorter;
    return copy;
  }

  /**
   * A column in which searched words are not marked.
   *
   * @return a column like this
   */
  public Column<R> unsearched() {
    Column<R> copy = new Column<>(this);
    copy.highlighted = false;
    return copy;
  }

  /**
   * The heading.
   *
   * @return the words
   */
  public String title() {
    return title;
  }

  /**
   * What it shows.
   *
   * @param row the row
   * @return the words
   */
  public String text(R row) {
    return text.apply(row);
  }

  /**
   * The order of rows by this column.
   *
   * @return the ascending order, or none where it cannot be sorted by
   */
  public Optional<Comparator<R>> order() {
    return order;
  }

  /** What is shown of a row: the whole text where it fits. */
  String fitting(R row, Predicate<String> fits) {
    String whole = CellPainter.line(text(row));
    return fits.test(whole) ? whole : brief.apply(whole);
  }

  Role role(R row) {
    return role.apply(row);
  }

  String hint(R row) {
    return hint.apply(row);
  }

  Optional<CellPaint<R>> paint() {
    return paint;
  }

  Optional<Health> dot(R row) {
    return dot.map(health -> health.apply(row));
  }

  boolean dotted() {
    return dot.isPresent();
  }

  Face face() {
    return face;
  }

  boolean right() {
    return right;
  }

  boolean highlighted() {
    return highlighted;
  }

  double weight() {
    return weight;
  }

  int width() {
    return width;
  }

  int needed() {
    return needed;
  }
}
