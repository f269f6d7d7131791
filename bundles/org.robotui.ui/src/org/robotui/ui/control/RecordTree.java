package org.robotui.ui.control;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.function.BiConsumer;
import java.util.function.Consumer;
import java.util.function.Function;
import org.eclipse.swt.SWT;
import org.eclipse.swt.widgets.Composite;
import org.eclipse.swt.widgets.Control;
import org.eclipse.swt.widgets.Event;
import org.robotui.api.port.InputState;
import org.robotui.data.record.DynamicRecord;
import org.robotui.ui.Health;
import org.robotui.ui.Theme;
import org.robotui.ui.ViewAction;

/**
 * Shows a record as a tree of its fields. The next record of the type is shown in place: what is open, selected and
 * scrolled to stays. Long arrays come in pages. Right and left arrow open and close, Ctrl+C copies path and value. Only
 * what is seen is made into words, so that a record of many kilobytes can be shown at the rate at which it comes.
 * Display thread only.
 */
public final class RecordTree {
  private final RecordLook look;
  private final RowList<RecordRow> list;
  private final RecordRows rows = new RecordRows();
  private Optional<DynamicRecord> record = Optional.empty();
  private Consumer<String> opened = path -> {};
  private BiConsumer<PopupMenu, String> first = (menu, path) -> {};

  /**
   * An empty tree.
   *
   * @param parent the parent
   * @param theme colours and fonts
   */
  public RecordTree(Composite parent, Theme theme) {
    look = new RecordLook(theme);
    list = new RowList<>(parent, theme, look).named("Fields").onOpen(this::open);
    list.menu(this::entries);
    list.input().first(this::key, this::pressed);
  }

  /**
   * What stands in the layout.
   *
   * @return the control
   */
  public Control control() {
    return list.control();
  }

  /**
   * Shows a record.
   *
   * @param next usually of the same type as the one before
   */
  public void show(DynamicRecord next) {
    record = Optional.of(next);
    update();
  }

  /** Shows no record. */
  public void clear() {
    record = Optional.empty();
    update();
  }

  /**
   * Shows the state of the input that the records come from.
   *
   * @param state the state
   */
  public void state(InputState state) {
    list.state(state);
  }

  /**
   * Shows a message in place of the tree.
   *
   * @param health its dot
   * @param title a few words
   * @param sentence what is so and what would help
   */
  public void message(Health health, String title, String sentence) {
    list.message(health, title, sentence);
  }

  /** Shows the tree again. */
  public void noMessage() {
    list.noMessage();
  }

  /**
   * Marks words in names and values.
   *
   * @param words what was searched, empty for nothing
   */
  public void highlight(String words) {
    look.search(words);
    list.redraw();
  }

  /** Opens all records within, and lists of them, as far as that is of use. */
  public void expandAll() {
    rows.openAll();
    update();
  }

  /** Closes all. */
  public void collapseAll() {
    rows.closeAll();
    update();
  }

  /**
   * Tells when a field that holds no others is opened, by Enter or a double-click.
   *
   * @param action is given its path
   * @return this
   */
  public RecordTree onOpen(Consumer<String> action) {
    opened = action;
    return this;
  }

  /**
   * What the search keys do.
   *
   * @param action for example focus of a {@link FilterField}
   * @return this
   */
  public RecordTree onFind(Runnable action) {
    list.onFind(action);
    return this;
  }

  /**
   * Lets fields be dragged as text, for example into a plot.
   *
   * @param text is given a path, and gives the text, none where it cannot be dragged
   * @return this
   */
  public RecordTree drag(Function<String, Optional<String>> text) {
    list.drag(row -> text.apply(row.fieldPath()));
    return this;
  }

  /**
   * Begins the context menu with entries of its own, also with menus within it.
   *
   * @param fill is given the menu and the path of the selected field
   * @return this
   */
  public RecordTree menu(BiConsumer<PopupMenu, String> fill) {
    first = fill;
    return this;
  }

  /**
   * The path of the selected field.
   *
   * @return for example {@code pose.position.x}
   */
  public Optional<String> selected() {
    return list.leading().map(RecordRow::fieldPath);
  }

  RowList<RecordRow> list() {
    return list;
  }

  private void update() {
    list.show(record.map(rows::of).orElse(List.of()));
  }

  private void turn(RecordRow row) {
    rows.turn(row.path());
    update();
  }

  private void open(RecordRow row) {
    if (row.expandable()) {
      turn(row);
    } else {
      opened.accept(row.path());
    }
  }

  private boolean pressed(Event event) {
    int index = list.scroll().indexAt(event.y);
    RecordRow row = list.rows().get(index);
    boolean turns = event.button == 1 && look.isChevron(row, event.x);
    if (turns) {
      turn(row);
    }
    return turns;
  }

  private boolean key(Event event) {
    boolean right = event.keyCode == SWT.ARROW_RIGHT;
    if (!right && event.keyCode != SWT.ARROW_LEFT) {
      return false;
    }
    list.leading().ifPresent(row -> sideways(row, right));
    return true;
  }

  private void sideways(RecordRow row, boolean right) {
    if (row.expandable() && row.expanded() != right) {
      turn(row);
    } else if (!right) {
      parent(row).ifPresent(parent -> list.select(parent.path()));
    }
  }

  private Optional<RecordRow> parent(RecordRow row) {
    List<RecordRow> before = list.rows().subList(0, list.marks().leadIndex()).reversed();
    return before.stream().filter(above -> above.depth() < row.depth()).findFirst();
  }

  private void entries(PopupMenu menu, List<RecordRow> selected) {
    selected.stream().findFirst().ifPresent(row -> {
      first.accept(menu, row.fieldPath());
      menu.line();
      actions(row).forEach(menu::action);
    });
  }

  private List<ViewAction> actions(RecordRow row) {
    List<ViewAction> actions = new ArrayList<>();
    actions.add(action("copy.value", "Copy value", () -> Clipboards.copy(RecordText.full(row.value()))));
    actions.add(action("copy.path", "Copy path", () -> Clipboards.copy(row.fieldPath())));
    actions.add(action("expand", "Expand all", this::expandAll));
    actions.add(action("collapse", "Collapse all", this::collapseAll));
    return actions;
  }

  private static ViewAction action(String id, String label, Runnable run) {
    return new ViewAction(id, label, "", Optional.empty(), run);
  }
}
